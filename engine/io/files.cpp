#include "engine/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>

namespace pinfield {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Failure> refused(const std::string& what, const std::string& path) {
    return failure(fmt::format("cannot {} {}: {}", what, path, std::strerror(errno)));
}

/// A call that a signal interrupted is made again.
template <class Call>
auto again(Call call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

/// A descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Interrupted, it is closed nevertheless.
    bool close() {
        const int number = number_;
        number_ = -1;
        return number < 0 || ::close(number) == 0 || errno == EINTR;
    }

private:
    int number_;
};

bool write_all(int descriptor, const std::string& content) {
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t count = again([&] { return ::write(descriptor, content.data() + done, content.size() - done); });
        if (count <= 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

/// A symbolic link stays one: what it points at is replaced.
fs::path real_target(const std::string& path) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : target;
}

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// What a file is replaced by stands beside it until it is whole, under a name that begins like this.
std::string temporary_prefix(const fs::path& target) { return fmt::format(".{}.saving-", target.filename().string().substr(0, 200)); }

/// Whoever replaces files in a folder holds its lock, so that what is compared is what is replaced, and a temporary file found there was
/// left by a process that died. Where a folder cannot be opened or locked, one goes without.
class FolderLock {
public:
    explicit FolderLock(const fs::path& folder) : folder_(again([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); })) {
        constexpr int most_tries = 200;  // 2 s: nobody holds it longer than it takes to write a table
        for (int i = 0; folder_ && i < most_tries; ++i) {
            if (::flock(folder_.number(), LOCK_EX | LOCK_NB) == 0) {
                held_ = true;
                return;
            }
            if (errno != EWOULDBLOCK && errno != EINTR) return;
            busy_ = errno == EWOULDBLOCK;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
    bool held() const { return held_; }
    bool busy() const { return busy_ && !held_; }
    /// Makes a rename survive a power cut. Not every file system lets a folder be synced; the file's own content is safe by then.
    bool sync() {
        return !folder_ || again([&] { return ::fsync(folder_.number()); }) == 0 || errno == EINVAL || errno == EOPNOTSUPP;
    }

private:
    Descriptor folder_;
    bool held_ = false, busy_ = false;
};

void clear_strays(const fs::path& target) {
    const std::string prefix = temporary_prefix(target);
    std::error_code error;
    for (fs::directory_iterator it(folder_of(target), error), end; !error && it != end; it.increment(error))
        if (it->path().filename().string().starts_with(prefix)) ::unlink(it->path().c_str());
}

/// Mode and owner of a file, for the one that replaces it; nothing for one that is not there.
Result<std::optional<struct stat>> status_of(const fs::path& target, const std::string& path) {
    struct stat status {};
    if (again([&] { return ::stat(target.c_str(), &status); }) == 0) {
        if (!S_ISREG(status.st_mode)) return failure(fmt::format("cannot write {}: it is no ordinary file", path));
        // Renaming over it would be allowed, but is not what its owner meant.
        if ((status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
            return failure(fmt::format("cannot write {}: it is read-only; another name, or chmod u+w, helps", path));
        return std::optional(status);
    }
    if (errno != ENOENT && errno != ENOTDIR) return refused("write", path);
    struct stat link {};
    if (::lstat(target.c_str(), &link) == 0) return failure(fmt::format("cannot write {}: it is a link to a file that is not there", path));
    return std::optional<struct stat>();
}

bool fill(const Descriptor& out, const std::string& content, const std::optional<struct stat>& like) {
    if (like) {  // the umask may have taken bits away; the owner is kept where the system allows it
        if (::fchown(out.number(), like->st_uid, like->st_gid) != 0) errno = 0;
        if (again([&] { return ::fchmod(out.number(), like->st_mode & 07777); }) != 0) return false;
    }
    return write_all(out.number(), content) && again([&] { return ::fsync(out.number()); }) == 0;
}

/// Tries names for a temporary file until one is free. Its path, or empty: why not is in errno.
template <class Make>
fs::path made_beside(const fs::path& target, Make make) {
    for (int i = 0; i < 100; ++i) {
        const fs::path temporary = folder_of(target) / fmt::format("{}{}", temporary_prefix(target), i);
        if (again([&] { return make(temporary.c_str()); }) >= 0) return temporary;
        if (errno != EEXIST) return {};
    }
    return {};
}

/// Puts a file with this content in the place of the target, whole or not at all. Messages speak of the file that the user knows.
/// `nameless`: until it is whole the file has no name where there are such files, and goes with the process whenever that dies.
Result<bool> replace_file(const fs::path& target, const std::string& content, const std::optional<struct stat>& like, FolderLock& lock,
                          const std::string& path, bool nameless = true) {
    if (lock.held()) clear_strays(target);
    const mode_t mode = like ? 0600 : 0666;
    fs::path temporary;
    int number = -1;
    if (nameless) number = again([&] { return ::open(folder_of(target).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, mode); });
    nameless = number >= 0;
    const auto make = [&](const char* name) { return number = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode); };
    if (!nameless) temporary = made_beside(target, make);
    Descriptor out(number);
    if (!out) return refused("write", path);
    bool done = fill(out, content, like);
    if (done && nameless) {
        const std::string self = fmt::format("/proc/self/fd/{}", out.number());
        temporary = made_beside(target, [&](const char* name) { return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW); });
        if (temporary.empty()) return replace_file(target, content, like, lock, path, false);
    }
    done = done && out.close() && again([&] { return ::rename(temporary.c_str(), target.c_str()); }) == 0;
    if (!done) {
        const auto failed = refused("write", path);
        if (!temporary.empty()) ::unlink(temporary.c_str());
        return failed;
    }
    if (!lock.sync()) return refused("make sure of", path);
    return true;
}

tl::unexpected<Failure> busy(const std::string& path) {
    return failure(fmt::format("cannot write {}: another program is saving in its folder", path));
}

/// What was there, beside the file: a courtesy, which never keeps anybody from saving. A link of that name is replaced, not followed.
void keep_backup(const fs::path& target, const std::string& content, const struct stat& like, FolderLock& lock) {
    fs::path backup = target;
    backup += ".bak";
    static_cast<void>(replace_file(backup, content, like, lock, backup.string()));
}

}  // namespace

Result<FileStart> read_file_start(const std::string& path, std::size_t most) {
    Descriptor in(again([&] { return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); }));
    if (!in) return refused("open", path);
    struct stat status {};
    if (again([&] { return ::fstat(in.number(), &status); }) != 0) return refused("read", path);
    if (!S_ISREG(status.st_mode)) return failure(fmt::format("cannot read {}: it is no ordinary file", path));
    FileStart start;
    char buffer[1 << 16];
    while (start.content.size() <= most) {
        const ssize_t count = again([&] { return ::read(in.number(), buffer, sizeof buffer); });
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
    FolderLock lock(folder_of(target));
    if (lock.busy()) return busy(path);
    const auto status = status_of(target, path);
    if (!status) return tl::unexpected<Failure>(status.error());
    return replace_file(target, content, *status, lock, path);
}

Result<bool> save_file(const std::string& path, const std::string& content, const std::optional<std::string>& expected) {
    const fs::path target = real_target(path);
    FolderLock lock(folder_of(target));
    if (lock.busy()) return busy(path);
    const auto status = status_of(target, path);
    if (!status) return tl::unexpected<Failure>(status.error());
    if (*status && !expected) return failure(fmt::format("{} exists already", path));
    if (!*status && expected) return failure(fmt::format("{} is gone from the disk", path));
    if (*status) {
        const Result<std::string> now = read_file(path);
        if (!now) return tl::unexpected<Failure>(now.error());
        if (*now == content) return lock.sync() ? Result<bool>(true) : refused("make sure of", path);
        if (*now != *expected) return failure(fmt::format("{} was changed by another program", path));
        keep_backup(target, *now, **status, lock);
    }
    return replace_file(target, content, *status, lock, path);
}

}  // namespace pinfield
