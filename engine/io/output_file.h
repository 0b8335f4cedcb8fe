// Results of any size, written piece by piece: an output is there whole, or what was there before is.
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace pinfield {

class Replacement;

class OutputFile {
public:
    OutputFile(OutputFile&&) noexcept;
    OutputFile& operator=(OutputFile&&) noexcept;
    ~OutputFile();  ///< without finish(): nothing was written

    /// Fails when there is something that is no ordinary file, is read-only or a link to nothing, or when the folder refuses a new file. A
    /// symbolic link stays, and what it points at is replaced; mode and, where the system lets it, owner stay.
    static Result<OutputFile> open(const std::string& path);
    Result<bool> write(std::string_view bytes);
    /// All of it is on the disk, in the place of what was there.
    Result<bool> finish();

private:
    struct State;
    explicit OutputFile(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Is there something at this path that is written as it comes, as it cannot be replaced: a device, a pipe? False for what is not there.
bool is_stream(const std::string& path);

/// For the beginning of a program. Its three standard streams exist from now on, closed ones as such that refuse all that is done with them:
/// else the first file that is opened would be stdout. And a reader that goes away is a failure to write, not the end of the process.
void hold_standard_streams();

}  // namespace pinfield
