#include "engine/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/io/files_replaced.h"

namespace pinfield {
namespace {

namespace fs = std::filesystem;

/// Puts a file with this content in the place of the target, whole or not at all. `expected`: of a document, what it takes the place of.
Result<bool> replace_file(const fs::path& target, const std::string& content, const FileStatus& like, FolderLock& lock, const std::string& path,
                          const std::string* expected = nullptr, bool nameless = true) {
    if (lock.held()) clear_strays(target);
    Replacement replacement(target, path, like);
    Result<bool> done = replacement.begin(nameless);
    if (done) done = replacement.write(content);
    if (done) done = replacement.ready();
    if (replacement.needs_name()) return replace_file(target, content, like, lock, path, expected, false);
    if (!done) return done;
    if (expected) {
        const auto exchanged = replacement.exchange(*expected, backup_of(target), lock);
        if (!exchanged) return tl::unexpected<Failure>(exchanged.error());
        if (*exchanged) return true;
        if (const auto now = read_file(path); !now || *now != *expected)  // as late as can be
            return now ? failure(fmt::format("{} was changed by another program", path)) : tl::unexpected<Failure>(now.error());
        static_cast<void>(replace_file(backup_of(target), *expected, like, lock, path));
    }
    return replacement.put_in_place(lock);
}

}  // namespace

Result<FileStart> read_file_start(const std::string& path, std::size_t most) {
    Descriptor in(again([&] { return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); }));
    if (!in) return refused("open", path);
    return read_open_file(in.number(), path, most);
}

Result<FileStart> read_open_file(int descriptor, const std::string& path, std::size_t most) {
    struct stat status {};
    if (again([&] { return ::fstat(descriptor, &status); }) != 0) return refused("read", path);
    if (!S_ISREG(status.st_mode)) return failure(fmt::format("cannot read {}: it is no ordinary file", path));
    FileStart start;
    char buffer[1 << 16];
    while (start.content.size() <= most) {
        const ssize_t count = again([&] { return ::read(descriptor, buffer, sizeof buffer); });
        if (count < 0) return refused("read", path);
        if (count == 0) return start;
        start.content.append(buffer, static_cast<std::size_t>(count));
    }
    start.content.resize(most);
    start.whole = false;
    return start;
}

Result<std::string> read_file(const std::string& path, std::size_t most) {
    Result<FileStart> start = read_file_start(path, most);
    if (!start) return tl::unexpected<Failure>(start.error());
    if (!start->whole) return failure(fmt::format("cannot read {}: it is larger than {} bytes", path, most));
    return std::move(start->content);
}

Result<bool> write_file(const std::string& path, const std::string& content) {
    const fs::path target = real_target(path);
    FolderLock lock(target);
    if (lock.busy()) return busy_folder(path);
    const auto status = status_of(target, path);
    if (!status) return tl::unexpected<Failure>(status.error());
    return replace_file(target, content, *status, lock, path);
}

Result<bool> save_file(const std::string& path, const std::string& content, const std::optional<std::string>& expected) {
    const fs::path target = real_target(path);
    FolderLock lock(target);
    if (lock.busy()) return busy_folder(path);
    const auto status = status_of(target, path);
    if (!status) return tl::unexpected<Failure>(status.error());
    if (*status && !expected) return failure(fmt::format("{} exists already", path));
    if (!*status && expected) return failure(fmt::format("{} is gone from the disk", path));
    if (*status) {
        const Result<std::string> now = read_file(path);
        if (!now) return tl::unexpected<Failure>(now.error());
        if (*now == content) return lock.sync() ? Result<bool>(true) : refused("make sure of", path);
        if (*now != *expected) return failure(fmt::format("{} was changed by another program", path));
    }
    return replace_file(target, content, *status, lock, path, expected ? &*expected : nullptr);
}

std::string backup_of(const std::string& path) { return path + ".pinfield.bak"; }

}  // namespace pinfield
