#include "engine/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace pinfield::cli {

Option Option::required() const { return option_->required(), *this; }
Option Option::check(CheckText why_invalid) const { return option_->check(std::move(why_invalid)), *this; }
Option Option::range(int least, int most) const { return option_->check(CLI::Range(least, most)), *this; }
Option Option::one_of(std::vector<std::string> words) const { return option_->check(CLI::IsMember(words)), offer(std::move(words)); }
Option Option::show_default() const { return option_->capture_default_str(), *this; }
Option Option::one_at_a_time() const { return option_->allow_extra_args(false), *this; }
Option Option::needs(Option other) const { return option_->needs(other.option_), *this; }
Option Option::excludes(Option other) const { return option_->excludes(other.option_), *this; }
Option Option::hidden() const { return option_->group(""), *this; }

Option Option::offer(Offer::Kind kind) const {
    (*offers_)[option_] = {kind};
    return *this;
}
Option Option::offer(std::vector<std::string> words) const {
    (*offers_)[option_] = {Offer::Kind::words, std::move(words)};
    return *this;
}

Command Command::subcommand(const std::string& name, const std::string& doc) const { return {app_->add_subcommand(name, doc), offers_}; }

Option Command::option(const std::string& name, std::string& target, const std::string& doc) const {
    return {app_->add_option(name, target, doc), offers_};
}
Option Command::option(const std::string& name, std::vector<std::string>& target, const std::string& doc) const {
    return {app_->add_option(name, target, doc), offers_};
}
Option Command::option(const std::string& name, int& target, const std::string& doc) const {
    return {app_->add_option(name, target, doc), offers_};
}
Option Command::option(const std::string& name, std::optional<int>& target, const std::string& doc) const {
    return {app_->add_option(name, target, doc), offers_};
}
Option Command::option(const std::string& name, std::uint64_t& target, const std::string& doc) const {
    return {app_->add_option(name, target, doc), offers_};
}
Option Command::option(const std::string& name, CheckText take, const std::string& doc) const {
    const auto take_or_throw = [name, take = std::move(take)](const std::string& text) {
        const std::string complaint = take(text);
        if (!complaint.empty()) throw CLI::ValidationError(name, complaint);
    };
    return {app_->add_option_function<std::string>(name, take_or_throw, doc), offers_};
}

Option Command::flag(const std::string& name, bool& target, const std::string& doc) const {
    return {app_->add_flag(name, target, doc), offers_};
}

CommandForm Command::form() const {
    CommandForm out{app_->get_name(), {}, {}};
    for (const CLI::Option* option : app_->get_options()) {
        if (option->get_group().empty()) continue;
        OptionForm form{{}, option->get_items_expected_max() > 0, {}};
        for (const std::string& name : option->get_lnames()) form.names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) form.names.push_back("-" + name);
        if (const auto offer = offers_->find(option); offer != offers_->end()) form.offer = offer->second;
        out.options.push_back(std::move(form));
    }
    for (CLI::App* below : app_->get_subcommands([](CLI::App*) { return true; })) out.subcommands.push_back(Command(below, offers_).form());
    return out;
}

void Command::callback(std::function<void()> run) const { app_->callback(std::move(run)); }

}  // namespace pinfield::cli
