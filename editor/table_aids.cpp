#include "editor/table_aids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/core/hash.h"
#include "engine/io/files.h"
#include "engine/io/quantity.h"

namespace pinfield::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 64 << 10, most_files = 200;
constexpr double farthest = 100;  ///< metres from the table's origin

std::string absolute(const std::string& table) {
    std::error_code unknown;
    return table.empty() ? std::string() : fs::absolute(table, unknown).lexically_normal().string();
}

/// " x 120mm" of "guide: x 120mm".
void read_guide(std::string_view text, TableAids& aids) {
    if (text.size() < 4 || text[0] != ' ' || (text[1] != 'x' && text[1] != 'y') || text[2] != ' ' || aids.guides.size() >= most_guides)
        return;
    const QuantityResult place = read_quantity(text.substr(3), Unit::metre);
    if (place && std::fabs(place->value) <= farthest) aids.guides.push_back({text[1] == 'x' ? 0 : 1, place->value});
}

/// The tables that were worked on longest ago are forgotten.
void forget_oldest(const std::string& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code unknown;
    for (fs::directory_iterator it(folder, unknown), end; !unknown && it != end; it.increment(unknown)) {
        std::error_code gone;
        const fs::file_time_type time = it->last_write_time(gone);
        if (!gone && it->path().extension() == ".aids") files.emplace_back(time, it->path());
    }
    if (files.size() <= most_files) return;
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + most_files < files.size(); ++i) fs::remove(files[i].second, unknown);
}

}  // namespace

TableAids read_aids(std::string_view text) {
    TableAids aids;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        if (line.starts_with("guide:")) read_guide(line.substr(6), aids);
        if (const std::size_t colon = line.find(": "); line.starts_with("underlay") && colon != std::string_view::npos)
            read_underlay_line(line.substr(0, colon), line.substr(colon + 2), aids.underlay);
        at = end + 1;
    }
    if (aids.underlay.path.empty() || !(aids.underlay.width > 0)) aids.underlay = {};
    return aids;
}

std::string write_aids(const std::string& table, const TableAids& aids) {
    std::string text = fmt::format("table: {}\n", table);
    for (const Guide& guide : aids.guides)
        text += fmt::format("guide: {} {}\n", guide.axis == 0 ? 'x' : 'y', write_quantity(guide.at, Unit::metre, "1mm"));
    return text + write_underlay(aids.underlay);
}

std::string AidsFolder::file_of(const std::string& table) const {
    return folder_ + "/" + Hash64().feed(std::string_view(table)).hex() + ".aids";
}

TableAids AidsFolder::open(const std::string& table) {
    table_ = absolute(table);
    known_ = {};
    if (folder_.empty() || table_.empty()) return {};
    const Result<std::string> text = read_file(file_of(table_), most_bytes);
    // Another table may have the same fingerprint.
    if (text && text->starts_with("table: " + table_ + "\n")) known_ = read_aids(*text);
    return known_;
}

void AidsFolder::keep(const std::string& table, const TableAids& now) {
    const std::string path = absolute(table);
    if (path == table_ && now == known_) return;
    table_ = path;
    known_ = now;
    if (folder_.empty() || path.empty() || path.find('\n') != std::string::npos) return;
    std::error_code unknown;
    const std::string file = file_of(path);
    const bool is_new = !fs::exists(file, unknown);
    if (is_new && now == TableAids{}) return;
    fs::create_directories(folder_, unknown);
    static_cast<void>(write_file(file, write_aids(path, now)));
    if (is_new) forget_oldest(folder_);
}

}  // namespace pinfield::editor
