#include "engine/io/files_replaced.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "engine/io/files.h"

namespace pinfield {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// What a file is replaced by stands beside it until it is whole, under a name that begins like this.
std::string temporary_prefix(const fs::path& target) { return fmt::format(".{}.saving-", target.filename().string().substr(0, 200)); }

bool write_all(int descriptor, std::string_view content) {
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t count = again([&] { return ::write(descriptor, content.data() + done, content.size() - done); });
        if (count <= 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
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

/// The umask may have taken bits away; the owner is kept where the system allows it.
bool make_alike(const Descriptor& out, const FileStatus& like) {
    if (!like) return true;
    if (::fchown(out.number(), like->st_uid, like->st_gid) != 0) errno = 0;
    return again([&] { return ::fchmod(out.number(), like->st_mode & 07777); }) == 0;
}

}  // namespace

bool Descriptor::close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0 || errno == EINTR;
}

tl::unexpected<Failure> refused(const std::string& what, const std::string& path) {
    return failure(fmt::format("cannot {} {}: {}", what, path, std::strerror(errno)));
}

fs::path real_target(const std::string& path) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : target;
}

FolderLock::FolderLock(const fs::path& target)
    : folder_(again([&] { return ::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); })) {
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

bool FolderLock::sync() {
    return !folder_ || again([&] { return ::fsync(folder_.number()); }) == 0 || errno == EINVAL || errno == EOPNOTSUPP;
}

tl::unexpected<Failure> busy_folder(const std::string& path) {
    return failure(fmt::format("cannot write {}: another program is saving in its folder", path));
}

Result<FileStatus> status_of(const fs::path& target, const std::string& path) {
    struct stat status {};
    if (again([&] { return ::stat(target.c_str(), &status); }) == 0) {
        if (!S_ISREG(status.st_mode)) return failure(fmt::format("cannot write {}: it is no ordinary file", path));
        // Renaming over it would be allowed, but is not what its owner meant.
        if ((status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
            return failure(fmt::format("cannot write {}: it is read-only; another name, or chmod u+w, helps", path));
        return FileStatus(status);
    }
    if (errno != ENOENT && errno != ENOTDIR) return refused("write", path);
    struct stat link {};
    if (::lstat(target.c_str(), &link) == 0) return failure(fmt::format("cannot write {}: it is a link to a file that is not there", path));
    return FileStatus();
}

void clear_strays(const fs::path& target) {
    const std::string prefix = temporary_prefix(target);
    std::error_code error;
    for (fs::directory_iterator it(folder_of(target), error), end; !error && it != end; it.increment(error)) {
        if (!it->path().filename().string().starts_with(prefix)) continue;
        const Descriptor stray(again([&] { return ::open(it->path().c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC); }));
        const bool in_use = stray && ::flock(stray.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        if (!in_use) ::unlink(it->path().c_str());
    }
}

Replacement::Replacement(fs::path target, std::string path, FileStatus like)
    : target_(std::move(target)), path_(std::move(path)), like_(std::move(like)) {}

Replacement::~Replacement() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Result<bool> Replacement::begin(bool nameless) {
    const mode_t mode = like_ ? 0600 : 0666;
    int number = -1;
    if (nameless) number = again([&] { return ::open(folder_of(target_).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, mode); });
    nameless_ = number >= 0;
    const auto make = [&](const char* name) { return number = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode); };
    if (!nameless_) temporary_ = made_beside(target_, make);
    out_.reset(number);
    if (!out_) return refused("write", path_);
    if (!nameless_ && ::flock(out_.number(), LOCK_EX | LOCK_NB) != 0) errno = 0;  // whom that keeps from nothing keeps nobody from it
    if (!make_alike(out_, like_)) return refused("write", path_);
    return true;
}

Result<bool> Replacement::write(std::string_view bytes) {
    if (!write_all(out_.number(), bytes)) return refused("write", path_);
    return true;
}

Result<bool> Replacement::ready() {
    if (again([&] { return ::fsync(out_.number()); }) != 0) return refused("write", path_);
    if (nameless_) {
        const std::string self = fmt::format("/proc/self/fd/{}", out_.number());
        temporary_ = made_beside(target_, [&](const char* name) { return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW); });
        needs_name_ = temporary_.empty();
        if (needs_name_) return refused("write", path_);
    }
    return true;
}

Result<std::optional<bool>> Replacement::exchange(const std::string& expected, const fs::path& backup, FolderLock& lock) {
#ifdef RENAME_EXCHANGE
    const auto swap = [&] {
        return again([&] { return ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE); }) == 0;
    };
    if (!out_.close()) return refused("write", path_);
    if (!swap()) {
        if (errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP) return std::optional<bool>();
        return refused("write", path_);
    }
    const Result<std::string> was = read_file(temporary_.string());
    if (!was || *was != expected) {
        if (!swap()) {  // what they wrote stays, under the name that is left
            const std::string left = std::exchange(temporary_, fs::path()).string();
            const bool moved = ::rename(left.c_str(), backup.c_str()) == 0;
            return failure(fmt::format("{} was changed by another program; what that wrote is in {}", path_, moved ? backup.string() : left));
        }
        return was ? failure(fmt::format("{} was changed by another program", path_)) : tl::unexpected<Failure>(was.error());
    }
    if (again([&] { return ::rename(temporary_.c_str(), backup.c_str()); }) != 0) ::unlink(temporary_.c_str());
    temporary_.clear();
    if (!lock.sync()) return refused("make sure of", path_);
    return std::optional<bool>(true);
#else
    static_cast<void>(expected), static_cast<void>(backup), static_cast<void>(lock);
    return std::optional<bool>();
#endif
}

Result<bool> Replacement::put_in_place(FolderLock& lock) {
    if ((out_ && !out_.close()) || again([&] { return ::rename(temporary_.c_str(), target_.c_str()); }) != 0) return refused("write", path_);
    temporary_.clear();
    if (!lock.sync()) return refused("make sure of", path_);
    return true;
}

}  // namespace pinfield
