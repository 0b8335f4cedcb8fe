// Where results go: a file or stdout, with every failure noticed, a full disk included. And where words for people go: stderr.
#pragma once
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/output_file.h"

namespace pinfield::cli {

class Output {
public:
    /// "" and "-" mean stdout; so does what stdout is already, as /dev/stdout. Devices and pipes are written as it comes; a file takes its place
    /// when it is whole. Stops the command when it cannot be opened.
    explicit Output(std::string path);
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// Stops the command when the device refuses the bytes.
    void write(std::string_view text);
    /// Flushes and closes: only after this is all of it written, and before it nothing of a file. Stops the command when it is not. A reader
    /// of stdout that went away has seen enough: that is no news for stderr.
    void finish();

private:
    [[noreturn]] void stop() const;

    std::string path_;
    std::FILE* stream_ = nullptr;  ///< stdout, a device or a pipe
    std::optional<OutputFile> file_;
};

/// Is this output stdout?
bool is_stdout(const std::string& path);

/// What is wrong with the path of an output, or "".
std::string why_no_output(const std::string& path);

/// Stops the command, before anything is written, when an output is one of the files it reads, by whatever name.
void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs);

/// Stops the command when both outputs are one file.
void refuse_sharing(const std::string& output, const std::string& other);

/// All of it to stdout.
void print(std::string_view text);

/// Words for people, to stderr. Where that is closed or full nobody is told, and the exit code stays what it is.
void tell(std::string_view text);

}  // namespace pinfield::cli
