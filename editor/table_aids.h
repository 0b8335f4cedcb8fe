// What an author lays over a table to work by, kept beside the preferences, a file a table. No window, no ImGui.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "editor/guides.h"
#include "editor/underlay.h"

namespace pinfield::editor {

struct TableAids {
    std::vector<Guide> guides{};
    Underlay underlay{};
    bool operator==(const TableAids&) const = default;
};

/// Lines of `guide: x 120mm`, and of `guide: y 0.5`, and those of an underlay; what is not understood is left out. At most most_guides.
inline constexpr std::size_t most_guides = 200;
TableAids read_aids(std::string_view text);
std::string write_aids(const std::string& table, const TableAids& aids);

/// A folder of them, one for each table by its path.
class AidsFolder {
public:
    /// Keeps nothing.
    AidsFolder() = default;
    explicit AidsFolder(std::string folder) : folder_(std::move(folder)) {}

    /// Of a table by its path (empty: a new one): none where nothing is known of it.
    TableAids open(const std::string& table);
    /// Writes what became different, or a table that goes by another path now. A courtesy: where it cannot be written, it stays as it is.
    void keep(const std::string& table, const TableAids& now);

private:
    std::string file_of(const std::string& table) const;

    std::string folder_, table_;
    TableAids known_;
};

}  // namespace pinfield::editor
