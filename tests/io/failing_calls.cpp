// The program's own open(), write() ... stand before the C library's for everything that is linked into it.
#include "tests/io/failing_calls.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>

namespace pinfield::test {
namespace {

struct Plan {
    bool active = false, repeated = false;
    Fault fault = Fault::io_error;
    std::size_t nth = 0;
    std::vector<std::string> calls{};
    std::string failed{};
};

Plan& plan() {
    static Plan plan;
    return plan;
}

/// Counts a call; true: it is to fail.
bool fails(const char* name, bool writes = false) {
    Plan& now = plan();
    if (!now.active) return false;
    now.active = false;  // a longer list may ask for memory, and that for anything
    now.calls.emplace_back(name);
    now.active = true;
    const std::size_t made = now.calls.size();
    const bool due = now.repeated ? made % now.nth == 0 : made == now.nth;
    if (!due || (now.fault == Fault::short_write && !writes)) return false;
    now.failed += std::string(name) + " ";
    switch (now.fault) {
        case Fault::io_error: errno = EIO; break;
        case Fault::disk_full: errno = ENOSPC; break;
        case Fault::interrupted: errno = EINTR; break;
        case Fault::short_write: break;
    }
    return true;
}

}  // namespace

FailingCalls::FailingCalls(std::size_t nth, Fault fault, bool repeated) { plan() = {true, repeated, fault, nth}; }
FailingCalls::~FailingCalls() { plan().active = false; }
const std::vector<std::string>& FailingCalls::calls() const { return plan().calls; }
const std::string& FailingCalls::failed() const { return plan().failed; }

}  // namespace pinfield::test

using pinfield::test::fails;
using pinfield::test::Fault;
using pinfield::test::plan;

extern "C" {

int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    if ((flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE) {
        va_list rest;
        va_start(rest, flags);
        mode = va_arg(rest, mode_t);
        va_end(rest);
    }
    if (fails("open")) return -1;
    return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int close(int file) {
    // A descriptor is gone even when closing it fails.
    const bool failing = fails("close");
    const int error = errno;
    const int result = static_cast<int>(::syscall(SYS_close, file));
    if (!failing) return result;
    errno = error;
    return -1;
}

ssize_t write(int file, const void* bytes, size_t count) {
    if (fails("write", true)) {
        if (plan().fault != Fault::short_write) return -1;
        count = (count + 1) / 2;
    }
    return ::syscall(SYS_write, file, bytes, count);
}

ssize_t read(int file, void* bytes, size_t count) { return fails("read") ? -1 : ::syscall(SYS_read, file, bytes, count); }
int fsync(int file) { return fails("fsync") ? -1 : static_cast<int>(::syscall(SYS_fsync, file)); }
int flock(int file, int operation) { return fails("flock") ? -1 : static_cast<int>(::syscall(SYS_flock, file, operation)); }
int fchmod(int file, mode_t mode) { return fails("fchmod") ? -1 : static_cast<int>(::syscall(SYS_fchmod, file, mode)); }
int fchown(int file, uid_t owner, gid_t group) { return fails("fchown") ? -1 : static_cast<int>(::syscall(SYS_fchown, file, owner, group)); }
int rename(const char* from, const char* to) { return fails("rename") ? -1 : static_cast<int>(::syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to)); }
int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
    return fails("renameat2") ? -1 : static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
    return fails("linkat") ? -1 : static_cast<int>(::syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}
int unlink(const char* path) { return fails("unlink") ? -1 : static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, 0)); }
int stat(const char* path, struct stat* status) {
    return fails("stat") ? -1 : static_cast<int>(::syscall(SYS_newfstatat, AT_FDCWD, path, status, 0));
}
int fstat(int file, struct stat* status) { return fails("fstat") ? -1 : static_cast<int>(::syscall(SYS_fstat, file, status)); }

}  // extern "C"
