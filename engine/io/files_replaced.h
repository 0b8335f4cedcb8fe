// How a file is replaced, whole or not at all: what files.cpp (documents) and output_file.cpp (results, piece by piece) share.
#pragma once
#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace pinfield {

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
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }
    void reset(int number) {
        close();
        number_ = number;
    }
    /// Interrupted, it is closed nevertheless.
    bool close();

private:
    int number_;
};

/// "cannot `what` `path`: " and what errno says.
tl::unexpected<Failure> refused(const std::string& what, const std::string& path);

/// A symbolic link stays one: what it points at is replaced.
std::filesystem::path real_target(const std::string& path);

/// Whoever replaces files in a folder holds its lock, so that what is compared is what is replaced. Where a folder cannot be opened or locked,
/// one goes without.
class FolderLock {
public:
    /// Of the folder that the target is in. Waits for 2 s at most.
    explicit FolderLock(const std::filesystem::path& target);
    bool held() const { return held_; }
    /// Somebody else holds it.
    bool busy() const { return busy_ && !held_; }
    /// Makes a rename survive a power cut. Not every file system lets a folder be synced; the file's own content is safe by then.
    bool sync();

private:
    Descriptor folder_;
    bool held_ = false, busy_ = false;
};
tl::unexpected<Failure> busy_folder(const std::string& path);

using FileStatus = std::optional<struct stat>;  ///< none: there is no such file

/// Mode and owner of a file, for the one that replaces it. Fails, in words that name `path`, for what is no ordinary file, is read-only, or is
/// a link to nothing.
Result<FileStatus> status_of(const std::filesystem::path& target, const std::string& path);

/// A file that is written beside its target and takes its place when it is whole. Until then it has no name where the system has such
/// files, and goes with the process whenever that dies; where it must have one, it is locked, and who replaces the same target later takes
/// away those that nobody holds. Messages speak of `path`, the file that the user knows.
class Replacement {
public:
    Replacement(std::filesystem::path target, std::string path, FileStatus like);
    ~Replacement();  ///< not put in place: nothing of it is left
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    Result<bool> begin(bool nameless = true);
    Result<bool> write(std::string_view bytes);
    /// Its bytes are on the disk, and it has a name beside its target.
    Result<bool> ready();
    /// What was at the target is gone, and this is there. `lock`: of its folder.
    Result<bool> put_in_place(FolderLock& lock);
    /// Likewise, when what is there is `expected`; it then becomes `backup`, where it can. The two change places at once, so that nothing which
    /// anybody puts there in between is lost: when what comes out is another, they change back. None: the system cannot do that here.
    Result<std::optional<bool>> exchange(const std::string& expected, const std::filesystem::path& backup, FolderLock& lock);
    /// ready() failed, as files without a name cannot be given one here, and one that begins with a name may do better.
    bool needs_name() const { return needs_name_; }

private:
    std::filesystem::path target_, temporary_;
    std::string path_;
    FileStatus like_;
    Descriptor out_;
    bool nameless_ = false, needs_name_ = false;
};

/// Takes away what processes that died left of replacing this target. Hold the folder's lock.
void clear_strays(const std::filesystem::path& target);

}  // namespace pinfield
