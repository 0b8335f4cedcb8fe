// Where results go: a file or stdout, with every failure noticed, a full disk included.
#pragma once
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace pinfield::cli {

class Output {
public:
    /// A file that is made or emptied; "" and "-" mean stdout. Stops the command when it cannot be opened.
    explicit Output(std::string path);
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// Stops the command when the device refuses the bytes.
    void write(std::string_view text);
    /// Flushes and closes: only after this is all of it written. Stops the command when it is not.
    void finish();

private:
    [[noreturn]] void stop() const;

    std::string path_;
    std::FILE* file_ = nullptr;
};

/// Stops the command, before anything is written, when an output is one of the files it reads, by whatever name.
void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs);

/// Stops the command when both outputs are one file.
void refuse_sharing(const std::string& output, const std::string& other);

/// All of it to stdout.
void print(std::string_view text);

}  // namespace pinfield::cli
