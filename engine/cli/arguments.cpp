#include "engine/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace pinfield::cli {

Option Option::required() const { return Option(option_->required()); }
Option Option::check(CheckText why_invalid) const { return Option(option_->check(std::move(why_invalid))); }
Option Option::range(int least, int most) const { return Option(option_->check(CLI::Range(least, most))); }
Option Option::one_of(std::vector<std::string> words) const { return Option(option_->check(CLI::IsMember(std::move(words)))); }
Option Option::show_default() const { return Option(option_->capture_default_str()); }
Option Option::one_at_a_time() const { return Option(option_->allow_extra_args(false)); }
Option Option::needs(Option other) const { return Option(option_->needs(other.option_)); }
Option Option::excludes(Option other) const { return Option(option_->excludes(other.option_)); }
Option Option::hidden() const { return Option(option_->group("")); }

Command Command::subcommand(const std::string& name, const std::string& doc) const { return Command(app_->add_subcommand(name, doc)); }

Option Command::option(const std::string& name, std::string& target, const std::string& doc) const {
    return Option(app_->add_option(name, target, doc));
}
Option Command::option(const std::string& name, std::vector<std::string>& target, const std::string& doc) const {
    return Option(app_->add_option(name, target, doc));
}
Option Command::option(const std::string& name, int& target, const std::string& doc) const {
    return Option(app_->add_option(name, target, doc));
}
Option Command::option(const std::string& name, std::optional<int>& target, const std::string& doc) const {
    return Option(app_->add_option(name, target, doc));
}
Option Command::option(const std::string& name, std::uint64_t& target, const std::string& doc) const {
    return Option(app_->add_option(name, target, doc));
}
Option Command::option(const std::string& name, CheckText take, const std::string& doc) const {
    const auto take_or_throw = [name, take = std::move(take)](const std::string& text) {
        const std::string complaint = take(text);
        if (!complaint.empty()) throw CLI::ValidationError(name, complaint);
    };
    return Option(app_->add_option_function<std::string>(name, take_or_throw, doc));
}

Option Command::flag(const std::string& name, bool& target, const std::string& doc) const {
    return Option(app_->add_flag(name, target, doc));
}

void Command::callback(std::function<void()> run) const { app_->callback(std::move(run)); }

}  // namespace pinfield::cli
