// Commands and their options, in front of CLI11. Only arguments.cpp and main.cpp include its headers: every unit that does optimises the
// whole parser, which takes as long as five other units.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Option;
}  // namespace CLI

namespace pinfield::cli {

/// What is wrong with what the user wrote, or "".
using CheckText = std::function<std::string(const std::string&)>;

/// What a shell may complete a value to.
struct Offer {
    enum class Kind : unsigned char { nothing, words, files, tables };
    Kind kind = Kind::nothing;
    std::vector<std::string> words{};
};

/// An option as the help tells it.
struct OptionForm {
    std::vector<std::string> names;  ///< "--output", "-o"; none of what stands without a name (FILE)
    bool takes_value = false;
    Offer offer;
};

/// A command as the help tells it.
struct CommandForm {
    std::string name;
    std::vector<OptionForm> options;  ///< those of the help, in its order
    std::vector<CommandForm> subcommands;
};

/// What is offered for which option: CLI11 has no place for it.
using Offers = std::map<const CLI::Option*, Offer>;

/// One option, whose rules can be chained: `command.option(...).required()`.
class Option {
public:
    Option(CLI::Option* option, std::shared_ptr<Offers> offers) : option_(option), offers_(std::move(offers)) {}

    Option required() const;
    Option check(CheckText why_invalid) const;
    Option range(int least, int most) const;
    Option one_of(std::vector<std::string> words) const;
    Option show_default() const;   ///< in the help
    Option one_at_a_time() const;  ///< a list grows by one value for each time the option is written
    Option needs(Option other) const;
    Option excludes(Option other) const;
    Option hidden() const;  ///< from the help
    Option offer(Offer::Kind kind) const;                ///< files or tables
    Option offer(std::vector<std::string> words) const;  ///< one_of() offers its own

private:
    CLI::Option* option_;
    std::shared_ptr<Offers> offers_;
};

/// A command or one of its subcommands. What the options write to must outlive the parsing.
class Command {
public:
    explicit Command(CLI::App* app) : Command(app, std::make_shared<Offers>()) {}

    Command subcommand(const std::string& name, const std::string& doc) const;
    Option option(const std::string& name, std::string& target, const std::string& doc) const;
    Option option(const std::string& name, std::vector<std::string>& target, const std::string& doc) const;
    Option option(const std::string& name, int& target, const std::string& doc) const;
    Option option(const std::string& name, std::optional<int>& target, const std::string& doc) const;
    Option option(const std::string& name, std::uint64_t& target, const std::string& doc) const;
    /// `take` gets the text and keeps what it wants of it.
    Option option(const std::string& name, CheckText take, const std::string& doc) const;
    Option flag(const std::string& name, bool& target, const std::string& doc) const;
    /// Runs when the user asked for this command and all its options are right.
    void callback(std::function<void()> run) const;
    /// All that has been added so far.
    CommandForm form() const;

private:
    Command(CLI::App* app, std::shared_ptr<Offers> offers) : app_(app), offers_(std::move(offers)) {}

    CLI::App* app_;
    std::shared_ptr<Offers> offers_;
};

}  // namespace pinfield::cli
