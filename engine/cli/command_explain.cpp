// pinfield explain [CODE]: what the code of an error or warning means, with an example of wrong and of right.
#include <fmt/format.h>

#include <algorithm>

#include "engine/cli/command.h"
#include "engine/cli/json.h"
#include "engine/cli/output.h"
#include "engine/core/closest.h"
#include "engine/core/explanations.h"

namespace pinfield::cli {
namespace {

struct Options {
    std::string code;
    bool json = false;
};

/// The codes in the order people look them up.
std::vector<Code> sorted_codes() {
    std::vector<Code> codes;
    for (const ErrorCode& code : error_codes()) codes.push_back(static_cast<Code>(&code - error_codes().data()));
    std::sort(codes.begin(), codes.end(), [](Code a, Code b) { return entry(a).code < entry(b).code; });
    return codes;
}

/// The code that is called so, by its number (e0203, [E0203]) or by its name (unknown_node). Stops the command where there is none.
Code code_called(const std::string& written) {
    std::string word;
    for (const char c : written)
        if (c != '[' && c != ']') word += c;
    const bool is_number = word.size() > 1 && word.find_first_of("0123456789") == 1;
    if (is_number && word[0] >= 'a' && word[0] <= 'z') word[0] = static_cast<char>(word[0] - 'a' + 'A');
    std::vector<std::string_view> known;
    for (const Code code : sorted_codes()) {
        if (entry(code).code == word || entry(code).name == word) return code;
        known.push_back(is_number ? entry(code).code : entry(code).name);
    }
    const std::string meant = suggestion(word, known);
    throw Stop{ExitCode::usage,
               fmt::format("there is no code \"{}\"; {}`pinfield explain` lists all", written, meant.empty() ? "" : meant + " "), ""};
}

/// Sentences as lines of at most 80 characters.
std::string wrapped(std::string_view text) {
    constexpr std::size_t width = 80;
    std::string out;
    while (text.size() > width) {
        std::size_t end = text.rfind(' ', width);
        if (end == std::string_view::npos) end = text.find(' ');
        if (end == std::string_view::npos) break;
        out.append(text.substr(0, end)).append("\n");
        text.remove_prefix(end + 1);
    }
    return out.append(text).append("\n");
}

std::string example_text(std::string_view title, std::string_view example) {
    if (example.empty()) return "";
    std::string out = fmt::format("\n{}:\n\n", title);
    while (!example.empty()) {
        const std::size_t end = std::min(example.find('\n'), example.size() - 1);
        out.append("    ").append(example.substr(0, end + 1));
        example.remove_prefix(end + 1);
    }
    return out;
}

const Explanation& explained(Code code) {
    const Explanation* found = explanation(code);
    if (!found) throw Stop{ExitCode::failed, fmt::format("nobody has explained {} yet", entry(code).code), ""};
    return *found;
}

std::string text_of(Code code) {
    const ErrorCode& which = entry(code);
    const Explanation& more = explained(code);
    return fmt::format("{} {}: {}\n\n", which.code, which.name, which.meaning) + wrapped(more.text) + example_text("wrong", more.wrong) +
           example_text("right", more.right);
}

std::string line_of(Code code) { return fmt::format("{} {:<22} {}\n", entry(code).code, entry(code).name, entry(code).meaning); }

std::string json_of(Code code) {
    const ErrorCode& which = entry(code);
    const Explanation& more = explained(code);
    return JsonObject()
        .add("code", which.code)
        .add("name", which.name)
        .add("severity", diagnose(code, {}, "").severity == Severity::error ? "error" : "warning")
        .add("meaning", which.meaning)
        .add("text", more.text)
        .add("wrong", more.wrong)
        .add("right", more.right)
        .text();
}

void explain(const Options& options) {
    const std::vector<Code> codes = options.code.empty() ? sorted_codes() : std::vector<Code>{code_called(options.code)};
    if (options.json) {
        std::vector<std::string> objects;
        objects.reserve(codes.size());
        for (const Code code : codes) objects.push_back(json_of(code));
        return print(json_array(objects) + "\n");
    }
    std::string text;
    for (const Code code : codes) text += options.code.empty() ? line_of(code) : text_of(code);
    print(text);
}

}  // namespace

void add_explain(const Command& app, ExitCode& exit) {
    const Command command = app.subcommand("explain", "Tell what an error's code means, with an example of wrong and of right");
    const auto options = std::make_shared<Options>();
    std::vector<std::string> words;
    for (const Code code : sorted_codes()) words.insert(words.end(), {std::string(entry(code).code), std::string(entry(code).name)});
    command.option("CODE", options->code, "Its code (E0203) or name; without, all are listed").offer(words);
    command.flag("--json", options->json, "As JSON");
    command.callback([options, &exit] {
        explain(*options);
        exit = ExitCode::fine;
    });
}

}  // namespace pinfield::cli
