#include "engine/io/files_below.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "engine/io/files.h"
#include "engine/io/files_replaced.h"

namespace pinfield {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Failure> not_opened(const std::string& path, const std::error_code& why) {
    return failure(fmt::format("cannot open {}: {}", path, why.message()));
}

/// Opens a file whose path has no links in it, a folder at a time and without following any: what takes a folder's place meanwhile leads nowhere.
Result<FileStart> read_real(const fs::path& root, const fs::path& below, const std::string& path, std::size_t most) {
    Descriptor folder(again([&] { return ::open(root.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
    for (const fs::path& word : below.parent_path()) {
        if (!folder) break;
        folder.reset(again([&] { return ::openat(folder.number(), word.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC); }));
    }
    if (!folder) return refused("open", path);
    const fs::path name = below.filename();
    struct stat status {};
    if (again([&] { return ::fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW); }) != 0) return refused("open", path);
    if (!S_ISREG(status.st_mode)) return failure(fmt::format("cannot read {}: it is no ordinary file", path));
    Descriptor in(again([&] { return ::openat(folder.number(), name.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC); }));
    if (!in) return refused("open", path);
    return read_open_file(in.number(), path, most);
}

}  // namespace

Result<FoundFile> read_below(const std::string& folder, const std::string& path, std::size_t most) {
    const std::string named = folder + path;
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, error);
    if (error) return not_opened(named, error);
    const fs::path real = fs::canonical(root / path, error);
    if (error) return not_opened(named, error);
    const fs::path below = real.lexically_relative(root);
    if (below.empty() || *below.begin() == "..") return failure(fmt::format("{} is a link that leads out of the table's folder", named));
    Result<FileStart> start = read_real(root, below, named, most);
    if (!start) return tl::unexpected<Failure>(start.error());
    return FoundFile{below.generic_string(), std::move(start->content)};
}

}  // namespace pinfield
