#include "editor/recent.h"

#include <algorithm>
#include <filesystem>

#include "engine/io/files.h"

namespace pinfield::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_paths = 10, most_bytes = 64 << 10;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        if (end > at) lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

}  // namespace

std::vector<std::string> RecentFiles::paths() const {
    if (file_.empty()) return {};
    const Result<std::string> text = read_file(file_, most_bytes);
    if (!text) return {};
    std::vector<std::string> paths = lines_of(*text);
    std::error_code unknown;
    std::erase_if(paths, [&](const std::string& path) { return !fs::is_regular_file(path, unknown); });
    return paths;
}

void RecentFiles::add(const std::string& path) const {
    if (file_.empty() || path.empty() || path.find('\n') != std::string::npos) return;
    std::error_code unknown;
    const fs::path whole = fs::absolute(path, unknown).lexically_normal();
    std::vector<std::string> known = paths();
    std::erase(known, whole.string());
    known.insert(known.begin(), whole.string());
    known.resize(std::min(known.size(), most_paths));
    std::string text;
    for (const std::string& each : known) text += each + "\n";
    fs::create_directories(fs::path(file_).parent_path(), unknown);
    static_cast<void>(write_file(file_, text));
}

}  // namespace pinfield::editor
