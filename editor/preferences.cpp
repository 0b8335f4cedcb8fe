#include "editor/preferences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "engine/core/numbers.h"
#include "engine/io/files.h"
#include "engine/io/quantity.h"

namespace pinfield::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 64 << 10;
constexpr double most_grid = 0.1;                        ///< metres
constexpr double least_extent = 60, most_extent = 4000;  ///< of panels, design pixels
constexpr std::string_view file_head =
    "# How Pinfield's editor looks and works. It changes values here; all else in this file stays as it is.\n";

constexpr std::string_view blank = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(blank), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(blank) + 1);
}

template <bool Preferences::*member>
constexpr PreferenceField yes_or_no(std::string_view key) {
    return {key, "true or false", [](const Preferences& p) { return std::string(p.*member ? "true" : "false"); },
            [](Preferences& p, std::string_view text) {
                if (text != "true" && text != "false") return false;
                p.*member = text == "true";
                return true;
            }};
}

bool take_number(std::string_view text, double least, double most, double& out) {
    const std::optional<double> number = parse_number(text);
    if (!number || !(*number >= least && *number <= most)) return false;
    out = *number;
    return true;
}

template <float Preferences::*member>
constexpr PreferenceField extent(std::string_view key) {
    return {key, "a number from 60 to 4000", [](const Preferences& p) { return to_text(static_cast<double>(p.*member), 0); },
            [](Preferences& p, std::string_view text) {
                double number = 0;
                if (!take_number(text, least_extent, most_extent, number)) return false;
                p.*member = static_cast<float>(number);
                return true;
            }};
}

bool take_theme(Preferences& p, std::string_view text) {
    if (text != "dark" && text != "light") return false;
    p.theme = text == "dark" ? ThemeChoice::dark : ThemeChoice::light;
    return true;
}

bool take_grid(Preferences& p, std::string_view text) {
    if (text == "off") return p.grid = 0, true;
    const QuantityResult read = read_quantity(text, Unit::metre);
    if (!read || !(read->value > 0 && read->value <= most_grid)) return false;
    p.grid = read->value;
    return true;
}

std::string favourites_text(const Preferences& p) { return fmt::format("[{}]", fmt::join(p.favourites, ", ")); }

/// "[star, bumper]": words of letters, digits and _.
bool take_favourites(Preferences& p, std::string_view text) {
    constexpr std::size_t most = 100;
    if (text.size() < 2 || text.front() != '[' || text.back() != ']') return false;
    std::vector<std::string> words;
    for (text = text.substr(1, text.size() - 2); !text.empty();) {
        const std::size_t end = std::min(text.find(','), text.size());
        const std::string_view word = trimmed(text.substr(0, end));
        const bool is_word =
            std::all_of(word.begin(), word.end(), [](char c) { return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z'); });
        if (word.empty() || !is_word || words.size() == most) return false;
        if (std::find(words.begin(), words.end(), word) == words.end()) words.emplace_back(word);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    p.favourites = std::move(words);
    return true;
}

constexpr PreferenceField fields[] = {
    {"theme", "dark or light", [](const Preferences& p) { return std::string(p.theme == ThemeChoice::dark ? "dark" : "light"); },
     take_theme},
    {"font_size", "a number from 8 to 48", [](const Preferences& p) { return to_text(p.font_size); },
     [](Preferences& p, std::string_view text) { return take_number(text, least_font_size, most_font_size, p.font_size); }},
    yes_or_no<&Preferences::snapping>("snapping"),
    {"grid", "a length up to 100mm, or off",
     [](const Preferences& p) { return p.grid > 0 ? write_quantity(p.grid, Unit::metre, "1mm") : std::string("off"); }, take_grid},
    {"favourites", "a list of nodes, such as [bumper, star]", favourites_text, take_favourites},
    yes_or_no<&Preferences::show_source>("show_source"),
    yes_or_no<&Preferences::show_changes>("show_changes"),
    yes_or_no<&Preferences::show_palette>("show_palette"),
    yes_or_no<&Preferences::show_history>("show_history"),
    yes_or_no<&Preferences::show_rulers>("show_rulers"),
    yes_or_no<&Preferences::show_guides>("show_guides"),
    yes_or_no<&Preferences::lock_guides>("lock_guides"),
    yes_or_no<&Preferences::warn_of_gaps>("warn_of_gaps"),
    extent<&Preferences::left>("left_width"),
    extent<&Preferences::right>("right_width"),
    extent<&Preferences::source_width>("source_width"),
    extent<&Preferences::palette_height>("palette_height"),
    extent<&Preferences::history_height>("history_height"),
    extent<&Preferences::problems_height>("problems_height"),
};

const PreferenceField* field_of(std::string_view key) {
    const auto found = std::find_if(std::begin(fields), std::end(fields), [&](const PreferenceField& field) { return field.key == key; });
    return found == std::end(fields) ? nullptr : found;
}

/// A line without its end; views of the text.
struct Line {
    std::string_view key, value;  ///< empty key: nothing but space or a comment
    bool is_pair = false;
};

Line line_of(std::string_view text) {
    std::size_t end = text.size();
    for (std::size_t i = 0; i < text.size() && end == text.size(); ++i)
        if (text[i] == '#' && (i == 0 || blank.find(text[i - 1]) != std::string_view::npos)) end = i;
    text = text.substr(0, end);
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return {trimmed(text), {}, false};
    return {trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1)), true};
}

/// Calls with each line and its number, from 1.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        visit(text.substr(at, end - at), ++number);
        at = end + 1;
    }
}

/// The value of a key in the line that counts, the last one.
std::string_view value_in(std::string_view text, std::string_view key) {
    std::string_view found;
    for_each_line(text, [&](std::string_view whole, int) {
        const Line line = line_of(whole);
        if (line.is_pair && line.key == key) found = line.value.data() ? line.value : whole.substr(whole.size());
    });
    return found;
}

void put(std::string& text, std::string_view key, const std::string& value) {
    const std::string_view found = value_in(text, key);
    if (found.data()) {
        const bool touches_colon = found.empty() && found.data() > text.data() && found.data()[-1] == ':';
        text.replace(static_cast<std::size_t>(found.data() - text.data()), found.size(), touches_colon ? " " + value : value);
        return;
    }
    if (!text.empty() && text.back() != '\n') text += '\n';
    text += fmt::format("{}: {}\n", key, value);
}

}  // namespace

bool is_favourite(const Preferences& preferences, std::string_view type) {
    return std::find(preferences.favourites.begin(), preferences.favourites.end(), type) != preferences.favourites.end();
}

void toggle_favourite(Preferences& preferences, std::string_view type) {
    if (std::erase(preferences.favourites, type) == 0) preferences.favourites.emplace_back(type);
}

std::span<const PreferenceField> preference_fields() { return fields; }

std::vector<std::string> read_preferences(std::string_view text, Preferences& preferences) {
    std::vector<std::string> complaints;
    for_each_line(text, [&](std::string_view whole, int number) {
        const Line line = line_of(whole);
        if (line.key.empty() && !line.is_pair) return;
        const PreferenceField* const field = line.is_pair ? field_of(line.key) : nullptr;
        if (!field)
            complaints.push_back(fmt::format("line {}: no preference is called {}", number, std::string(line.key.substr(0, 40))));
        else if (!field->take(preferences, line.value))
            complaints.push_back(
                fmt::format("line {}: {} is {}, not {}", number, field->key, field->wanted, std::string(line.value.substr(0, 40))));
    });
    return complaints;
}

std::string with_preferences(const std::string& text, const Preferences& before, const Preferences& now) {
    std::string out = text;
    for (const PreferenceField& field : fields)
        if (const std::string value = field.text(now); value != field.text(before)) put(out, field.key, value);
    return out;
}

Preferences PreferencesFile::read(std::vector<std::string>& complaints) {
    known_ = {};
    std::error_code unknown;
    if (path_.empty() || !fs::exists(path_, unknown)) return known_;
    const Result<std::string> text = read_file(path_, most_bytes);
    if (!text)
        complaints.push_back(text.error().message);
    else if (text->find('\0') != std::string::npos)
        complaints.push_back(fmt::format("{} is no text and is left alone", path_));
    else
        for (const std::string& complaint : read_preferences(*text, known_)) complaints.push_back(fmt::format("{}, {}", path_, complaint));
    return known_;
}

std::optional<std::string> PreferencesFile::keep(const Preferences& now) {
    if (path_.empty() || now == known_) return {};
    const Preferences before = std::exchange(known_, now);
    std::error_code unknown;
    std::string text(file_head);
    if (fs::exists(path_, unknown)) {
        Result<std::string> there = read_file(path_, most_bytes);
        if (!there) return fmt::format("The preferences are not kept: {}", there.error().message);
        if (there->find('\0') != std::string::npos) return fmt::format("The preferences are not kept: {} is no text", path_);
        text = std::move(*there);
    }
    const std::string after = with_preferences(text, before, now);
    if (after == text) return {};
    fs::create_directories(fs::path(path_).parent_path(), unknown);
    const Result<bool> written = write_file(path_, after);
    if (!written) return fmt::format("The preferences are not kept: {}", written.error().message);
    return {};
}

std::string preferences_folder() {
    const char* const config = std::getenv("XDG_CONFIG_HOME");
    if (config && config[0] == '/') return std::string(config) + "/pinfield";  // the XDG base directories: relative ones are ignored
    const char* const home = std::getenv("HOME");
    return home && home[0] == '/' ? std::string(home) + "/.config/pinfield" : std::string();
}

}  // namespace pinfield::editor
