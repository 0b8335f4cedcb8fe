#include "engine/cli/output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "engine/cli/command.h"

namespace pinfield::cli {

Output::Output(std::string path) : path_(std::move(path)) {
    if (path_.empty() || path_ == "-") {
        path_ = "stdout";
        file_ = stdout;
    } else {
        file_ = std::fopen(path_.c_str(), "wb");
        if (!file_) stop();
    }
}

Output::~Output() {
    if (file_ && file_ != stdout) std::fclose(file_);
}

void Output::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) stop();
}

void Output::finish() {
    std::FILE* file = std::exchange(file_, nullptr);
    const bool flushed = std::fflush(file) == 0;
    const int reason = errno;
    const bool closed = file == stdout || std::fclose(file) == 0;
    if (!flushed) errno = reason;
    if (!flushed || !closed) stop();
}

void Output::stop() const { throw Stop{ExitCode::failed, "cannot write " + path_ + ": " + std::strerror(errno)}; }

void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code missing;  // what does not exist cannot be overwritten
        if (!output.empty() && output != "-" && !input.empty() && std::filesystem::equivalent(output, input, missing))
            throw Stop{ExitCode::usage, fmt::format("{} is read by this command and cannot be written by it", output)};
    }
}

void refuse_sharing(const std::string& output, const std::string& other) {
    if (output.empty() || other.empty()) return;
    std::error_code error;
    if (std::filesystem::exists(output, error) && !std::filesystem::is_regular_file(output, error)) return;  // /dev/null holds all there is
    const auto place = [&](const std::string& path) { return std::filesystem::weakly_canonical(path, error); };
    if (output == other || place(output) == place(other))
        throw Stop{ExitCode::usage, fmt::format("{} cannot hold two outputs at once", output)};
}

void print(std::string_view text) {
    Output out("-");
    out.write(text);
    out.finish();
}

}  // namespace pinfield::cli
