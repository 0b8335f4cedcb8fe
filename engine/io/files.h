// Whole files in and out, so that no crash and no other program ever costs an author his table.
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "engine/core/result.h"

namespace pinfield {

/// Whole content of a file. Fails when it is no ordinary file, cannot be read, or is larger than `most` bytes.
Result<std::string> read_file(const std::string& path, std::size_t most = 64 << 20);

/// The first bytes of a file, and whether that is all of it.
struct FileStart {
    std::string content;
    bool whole = true;
};
Result<FileStart> read_file_start(const std::string& path, std::size_t most);
/// The same of a file that is open, which messages call by its path.
Result<FileStart> read_open_file(int descriptor, const std::string& path, std::size_t most);

/// Replaces a file's content, or makes the file; mode and, where the system lets it, owner stay. Readers see the old content or the new,
/// never half of it, whenever the machine stops. A read-only file is not replaced. A failure may come after the new content is there: when the disk does not confirm it.
Result<bool> write_file(const std::string& path, const std::string& content);

/// write_file() for a document: refuses when the disk no longer holds `expected` (nothing: the file must not exist yet), and keeps what
/// was there as backup_of(path) where that can be. Of two programs that save over the same content, by this function, one is refused; what
/// any other program puts there meanwhile is noticed, too, and stays (where the system can exchange two files; else up to a moment).
Result<bool> save_file(const std::string& path, const std::string& content, const std::optional<std::string>& expected);

/// Where save_file() keeps what was there: a name that nobody else gives, so that no file of the author's is replaced.
std::string backup_of(const std::string& path);

}  // namespace pinfield
