// Commands and their options, in front of CLI11. Only arguments.cpp and main.cpp include its headers: every unit that does optimises the
// whole parser, which takes as long as five other units.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pinfield::cli {

/// What is wrong with what the user wrote, or "".
using CheckText = std::function<std::string(const std::string&)>;

/// One option, whose rules can be chained: `command.option(...).required()`.
class Option {
public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option required() const;
    Option check(CheckText why_invalid) const;
    Option range(int least, int most) const;
    Option one_of(std::vector<std::string> words) const;
    Option show_default() const;   ///< in the help
    Option one_at_a_time() const;  ///< a list grows by one value for each time the option is written
    Option needs(Option other) const;
    Option excludes(Option other) const;
    Option hidden() const;  ///< from the help

private:
    CLI::Option* option_;
};

/// A command or one of its subcommands. What the options write to must outlive the parsing.
class Command {
public:
    explicit Command(CLI::App* app) : app_(app) {}

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

private:
    CLI::App* app_;
};

}  // namespace pinfield::cli
