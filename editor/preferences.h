// What the editor remembers of how somebody likes it, from one run to the next: a file of one preference a line. No window, no ImGui.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pinfield::editor {

enum class ThemeChoice : unsigned char { dark, light };

inline constexpr double least_font_size = 8, most_font_size = 48;

struct Preferences {
    ThemeChoice theme = ThemeChoice::dark;
    double font_size = 14;                  ///< design pixels; everything else grows with it
    bool snapping = true;                   ///< drags stop where edges and middles of others are
    double grid = 0.001;                    ///< of drags and arrow keys, metres; 0: none
    std::vector<std::string> favourites{};  ///< node types that stand first in the palette, by their words
    // Which panels stand open, and
    bool show_source = false;
    bool show_changes = true;  ///< lines that differ from the saved file are marked there
    bool show_palette = true;
    bool show_history = false;
    bool show_rulers = false;
    bool show_guides = true, lock_guides = false;
    bool warn_of_gaps = true;  ///< that are too narrow for a ball, during drags
    // how wide or high they are, in design pixels.
    float left = 250, right = 324, source_width = 400;
    float palette_height = 300, history_height = 220, problems_height = 132;

    bool operator==(const Preferences&) const = default;
};

bool is_favourite(const Preferences& preferences, std::string_view type);
void toggle_favourite(Preferences& preferences, std::string_view type);

/// One line of the file.
struct PreferenceField {
    std::string_view key;
    std::string_view wanted;  ///< what its values are, for a complaint: "dark or light"
    std::string (*text)(const Preferences&);
    bool (*take)(Preferences&, std::string_view text);  ///< false, and nothing is changed: it is no value of this one
};
std::span<const PreferenceField> preference_fields();

/// Lines of `key: value`, comments behind #. What cannot be understood stays what it was in `preferences` and is complained about.
std::vector<std::string> read_preferences(std::string_view text, Preferences& preferences);

/// The text with other values for what differs between two preferences. All else of it stays as it is, to the byte, be it understood or
/// not.
std::string with_preferences(const std::string& text, const Preferences& before, const Preferences& now);

/// The user's file of preferences.
class PreferencesFile {
public:
    /// Keeps nothing.
    PreferencesFile() = default;
    explicit PreferencesFile(std::string path) : path_(std::move(path)) {}

    /// What it says over the usual ones; its complaints are for people.
    Preferences read(std::vector<std::string>& complaints);
    /// Writes what became different since it was read or written last, and leaves the rest to other editors. Why it could not, once a
    /// change.
    std::optional<std::string> keep(const Preferences& now);
    /// What is different now is for this run only, and not kept.
    void pass_over(const Preferences& now) { known_ = now; }

private:
    std::string path_;
    Preferences known_;
};

/// $XDG_CONFIG_HOME/pinfield, else ~/.config/pinfield; empty where there is no home.
std::string preferences_folder();

}  // namespace pinfield::editor
