#include "engine/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace pinfield {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Failure> refused(const std::string& what, const std::string& path) {
    return failure(fmt::format("cannot {} {}: {}", what, path, std::strerror(errno)));
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
    bool close() {
        const int number = number_;
        number_ = -1;
        return number < 0 || ::close(number) == 0;
    }

private:
    int number_;
};

bool write_all(int descriptor, const std::string& content) {
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
        if (count < 0 && errno == EINTR) continue;
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

/// Makes a rename survive a power cut. Not every file system lets a folder be synced; the file's own content is safe by
/// then.
void sync_folder(const fs::path& folder) {
    const Descriptor descriptor(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY));
    if (descriptor) ::fsync(descriptor.number());
}

/// Messages speak of the file that the user knows.
Result<bool> write_synced(const fs::path& temporary, const std::string& content, mode_t mode, const std::string& path) {
    Descriptor out(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL, mode));
    if (!out) return refused("write", path);
    if (!write_all(out.number(), content) || ::fsync(out.number()) != 0 || !out.close()) {
        const auto failed = refused("write", path);
        ::unlink(temporary.c_str());
        return failed;
    }
    return true;
}

}  // namespace

Result<FileStart> read_file_start(const std::string& path, std::size_t most) {
    Descriptor in(::open(path.c_str(), O_RDONLY | O_NONBLOCK));
    if (!in) return refused("open", path);
    struct stat status {};
    if (::fstat(in.number(), &status) != 0) return refused("read", path);
    if (!S_ISREG(status.st_mode)) return failure(fmt::format("cannot read {}: it is no ordinary file", path));
    FileStart start;
    char buffer[1 << 16];
    while (start.content.size() <= most) {
        const ssize_t count = ::read(in.number(), buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
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
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && !S_ISREG(status.st_mode))
        return failure(fmt::format("cannot write {}: it is no ordinary file", path));
    const mode_t mode = exists ? status.st_mode & 07777 : 0666;
    const fs::path temporary = target.parent_path() / fmt::format(".{}.{}.tmp", target.filename().string(), ::getpid());
    ::unlink(temporary.c_str());  // left by a process of this number that was killed
    if (const auto written = write_synced(temporary, content, mode, path); !written) return written;
    if (exists) ::chmod(temporary.c_str(), mode);  // the umask may have taken bits away
    if (::rename(temporary.c_str(), target.c_str()) != 0) {
        const auto failed = refused("replace", path);
        ::unlink(temporary.c_str());
        return failed;
    }
    sync_folder(target.parent_path());
    return true;
}

Result<bool> save_file(const std::string& path, const std::string& content,
                       const std::optional<std::string>& expected) {
    std::error_code error;
    const bool exists = fs::exists(path, error);
    if (exists && !expected) return failure(fmt::format("{} exists already", path));
    if (!exists && expected) return failure(fmt::format("{} is gone from the disk", path));
    if (exists) {
        const Result<std::string> now = read_file(path);
        if (!now) return tl::unexpected<Failure>(now.error());
        if (*now != *expected) return failure(fmt::format("{} was changed by another program", path));
        if (*now == content) return true;
        if (const auto kept = write_file(path + ".bak", *now); !kept) return kept;
    }
    return write_file(path, content);
}

}  // namespace pinfield
