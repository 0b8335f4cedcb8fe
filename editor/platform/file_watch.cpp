#include "editor/platform/file_watch.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/inotify.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <cstring>
#endif

namespace pinfield::editor {
namespace {

namespace fs = std::filesystem;

/// The file and, where it is a link, all it stands for, each with its real folder.
std::vector<fs::path> way_to(const std::string& path) {
    constexpr int most_links = 40;
    std::vector<fs::path> way;
    std::error_code error;
    fs::path place = fs::absolute(path, error);
    for (int i = 0; i < most_links && !error; ++i) {
        place = fs::canonical(place.parent_path(), error) / place.filename();
        if (error) return {};
        way.push_back(place);
        if (!fs::is_symlink(place, error)) return way;
        const fs::path target = fs::read_symlink(place, error);
        place = target.is_absolute() ? target : place.parent_path() / target;
    }
    return {};
}

/// Of several files; of none where one of them has no folder: half of it is worse than none.
std::vector<fs::path> ways_to(const std::vector<std::string>& paths) {
    std::vector<fs::path> out;
    for (const std::string& path : paths) {
        const std::vector<fs::path> way = way_to(path);
        if (way.empty()) return {};
        out.insert(out.end(), way.begin(), way.end());
    }
    return out;
}

#ifdef __linux__
constexpr std::uint32_t events =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

/// Changes made on other machines are not told: NFS, SMB, CIFS, SMB2, AFS, 9P, Ceph, and what programs serve (FUSE).
bool is_elsewhere(const fs::path& folder) {
    struct statfs status {};
    if (::statfs(folder.c_str(), &status) != 0) return true;
    for (const std::uint32_t kind : {0x6969U, 0x517BU, 0xFF534D42U, 0xFE534D42U, 0x5346414FU, 0x01021997U, 0x00C36400U, 0x65735546U})
        if (static_cast<std::uint32_t>(status.f_type) == kind) return true;
    return false;
}

/// A file that was just made is written next, which is told, too; a link is whole at once.
bool is_whole_when_made(const fs::path& file) {
    struct stat status {};
    return ::lstat(file.c_str(), &status) == 0 && (S_ISLNK(status.st_mode) || status.st_nlink > 1);
}
#endif

}  // namespace

FileWatch::FileWatch(bool listens) : listens_(listens) {}

FileWatch::~FileWatch() { stop(); }

void FileWatch::follow(std::vector<std::string> paths) {
    if (paths == paths_) return;
    paths_ = std::move(paths);
    first_ = last_ = second_look_ = -1;
    listen();
}

bool FileWatch::due(double now) {
    if (paths_.empty()) return false;
    if (anything_happened()) {
        if (first_ < 0) first_ = now;
        last_ = now;
    }
    const bool stirred = first_ >= 0 && (now >= last_ + rest || now >= first_ + patience);
    const bool second = second_look_ >= 0 && now >= second_look_;
    if (!stirred && !second && now < next_look_) return false;
    if (is_lost_ || (!hears() && !stirred)) listen();
    if (stirred) {
        first_ = last_ = -1;
        second_look_ = now + again;
    } else if (second) {
        second_look_ = -1;
    }
    next_look_ = now + (hears() ? slow_period : poll_period);
    return true;
}

#ifdef __linux__

void FileWatch::listen() {
    stop();
    is_lost_ = false;
    if (!listens_ || paths_.empty()) return;
    const std::vector<fs::path> way = ways_to(paths_);
    queue_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    for (const fs::path& place : way) {
        const fs::path folder = place.parent_path();
        const int watch = queue_ < 0 || is_elsewhere(folder) ? -1 : ::inotify_add_watch(queue_, folder.c_str(), events);
        if (watch < 0) return stop();  // half of it is worse than none
        names_[watch].insert(place.filename().string());
    }
    if (names_.empty()) stop();
}

bool FileWatch::anything_happened() {
    if (queue_ < 0) return false;
    bool happened = false;
    alignas(inotify_event) std::array<char, 16 * 1024> buffer;
    for (ssize_t count = 0; (count = ::read(queue_, buffer.data(), buffer.size())) > 0;) {
        for (std::size_t at = 0; at < static_cast<std::size_t>(count);) {
            inotify_event event{};
            std::memcpy(&event, buffer.data() + at, sizeof event);
            const std::string name = event.len > 0 ? std::string(buffer.data() + at + sizeof event) : std::string();
            at += sizeof event + event.len;
            const bool of_folder = (event.mask & (IN_Q_OVERFLOW | IN_IGNORED | IN_DELETE_SELF | IN_MOVE_SELF)) != 0;
            const auto watched = names_.find(event.wd);
            const bool of_file = watched != names_.end() && watched->second.contains(name);
            if (!of_folder && !of_file) continue;
            if (of_file && (event.mask & IN_CREATE) != 0) {
                bool whole = false;
                for (const fs::path& place : ways_to(paths_)) whole = whole || (place.filename() == name && is_whole_when_made(place));
                if (!whole) continue;
            }
            happened = true;
            is_lost_ = is_lost_ || of_folder || names_.size() > 1 || watched->second.size() > 1;  // a link may lead elsewhere now
        }
    }
    std::error_code error;
    is_lost_ = is_lost_ || (happened && std::any_of(paths_.begin(), paths_.end(), [&](const std::string& path) { return fs::is_symlink(path, error); }));
    return happened;
}

void FileWatch::stop() {
    if (queue_ >= 0) ::close(queue_);
    queue_ = -1;
    names_.clear();
}

#else

void FileWatch::listen() { stop(); }
bool FileWatch::anything_happened() { return false; }
void FileWatch::stop() { names_.clear(); }

#endif

}  // namespace pinfield::editor
