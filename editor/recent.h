// Tables that were opened or saved lately: a file of one path a line, which all editors share. No window, no ImGui.
#pragma once
#include <string>
#include <vector>

namespace pinfield::editor {

class RecentFiles {
public:
    /// Remembers nothing.
    RecentFiles() = default;
    explicit RecentFiles(std::string file) : file_(std::move(file)) {}

    /// The last one first; those that are gone are left out.
    std::vector<std::string> paths() const;
    /// Makes a path the first. It is a courtesy: where the list cannot be written, it stays as it is.
    void add(const std::string& path) const;

private:
    std::string file_;
};

}  // namespace pinfield::editor
