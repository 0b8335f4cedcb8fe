#include "engine/cli/completion.h"

#include <fmt/format.h>

namespace pinfield::cli {
namespace {

/// The function up to the commands. Bash splits --mode=shaded at the =; the words about it are what they are without.
constexpr std::string_view head = R"(_{0}() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} options= words= offer= operand=nothing
    [[ $word == = ]] && word=
    [[ $before == = ]] && ((COMP_CWORD > 1)) && before=${{COMP_WORDS[COMP_CWORD - 2]}}
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        operand=words words='{1}' options='{2}'
    else
        case ${{COMP_WORDS[1]}} in
)";

constexpr std::string_view tail = R"(        esac
    fi
    if [[ -z $offer ]]; then
        if [[ $word == -* || $operand == nothing ]]; then offer=words words=$options; else offer=$operand; fi
    fi
    case $offer in
        words) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word") ;;
        files) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
        tables) mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.yaml' -- "$word"; compgen -f -X '!*.yml' -- "$word") ;;
    esac
    # Names of files are quoted and folders get their slash, but only in a shell that completes.
    case $offer in files | tables) compopt -o filenames 2> /dev/null ;; esac
    return 0
}}
complete -F _{0} {0}
)";

/// A single-quoted word list; our words have no quotes, and any would go.
std::string quotable(const std::vector<std::string>& words) {
    std::string out = fmt::format("{}", fmt::join(words, " "));
    std::erase(out, '\'');
    return out;
}

/// `offer` is what a value is completed to, `operand` what a word without an option before it is.
std::string assignment(std::string_view variable, const Offer& offer) {
    constexpr std::string_view names[] = {"nothing", "words", "files", "tables"};
    const std::string kind = fmt::format("{}={}", variable, names[static_cast<std::size_t>(offer.kind)]);
    return offer.kind == Offer::Kind::words ? fmt::format("{} words='{}'", kind, quotable(offer.words)) : kind;
}

/// The long names, or the short where there are no long ones.
std::vector<std::string> names_offered(const CommandForm& command) {
    std::vector<std::string> out;
    for (const OptionForm& option : command.options)
        if (!option.names.empty()) out.push_back(option.names.front());
    return out;
}

std::string case_of(const CommandForm& command) {
    std::string out = fmt::format("            {})\n                options='{}'\n                case $before in\n", command.name,
                                  quotable(names_offered(command)));
    Offer operand;
    for (const OptionForm& option : command.options) {
        if (option.names.empty()) operand = option.offer;
        else if (option.takes_value)
            out += fmt::format("                    {}) {} ;;\n", fmt::join(option.names, " | "), assignment("offer", option.offer));
    }
    return out + fmt::format("                    *) {} ;;\n                esac\n                ;;\n", assignment("operand", operand));
}

}  // namespace

std::string bash_completion(const CommandForm& program) {
    std::vector<std::string> commands;
    for (const CommandForm& command : program.subcommands) commands.push_back(command.name);
    std::string out = fmt::format(head, program.name, quotable(commands), quotable(names_offered(program)));
    for (const CommandForm& command : program.subcommands) out += case_of(command);
    return out + fmt::format(tail, program.name);
}

}  // namespace pinfield::cli
