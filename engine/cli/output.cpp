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
    if (path_.empty() || is_stdout(path_)) {
        path_ = "stdout";
        stream_ = stdout;
    } else if (is_stream(path_)) {
        stream_ = std::fopen(path_.c_str(), "wb");
        if (!stream_) stop();
    } else {
        file_.emplace(value_or_stop(OutputFile::open(path_)));
    }
}

Output::~Output() {
    if (stream_ && stream_ != stdout) std::fclose(stream_);
}

void Output::write(std::string_view text) {
    if (file_)
        value_or_stop(file_->write(text));
    else if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size())
        stop();
}

void Output::finish() {
    if (file_) {
        value_or_stop(file_->finish());
        return;
    }
    std::FILE* stream = std::exchange(stream_, nullptr);
    const bool flushed = std::fflush(stream) == 0;
    const int reason = errno;
    const bool closed = stream == stdout || std::fclose(stream) == 0;
    if (!flushed) errno = reason;
    if (!flushed || !closed) stop();
}

void Output::stop() const {
    const bool seen_enough = errno == EPIPE && path_ == "stdout";
    throw Stop{ExitCode::failed, seen_enough ? "" : "cannot write " + path_ + ": " + std::strerror(errno), ""};
}

bool is_stdout(const std::string& path) {
    std::error_code missing;
    return path == "-" || (!path.empty() && std::filesystem::equivalent(path, "/dev/stdout", missing) && path != "/dev/null");
}

std::string why_no_output(const std::string& path) { return path.empty() ? "an output needs a name, or - for stdout" : ""; }

void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code missing;  // what does not exist cannot be overwritten
        if (!output.empty() && output != "-" && !input.empty() && std::filesystem::equivalent(output, input, missing))
            throw Stop{ExitCode::usage, fmt::format("{} is read by this command and cannot be written by it", output), ""};
    }
}

void refuse_sharing(const std::string& output, const std::string& other) {
    if (output.empty() || other.empty()) return;
    const bool one_stream = is_stdout(output) && is_stdout(other);
    std::error_code error;
    if (!one_stream && std::filesystem::exists(output, error) && !std::filesystem::is_regular_file(output, error)) return;  // /dev/null holds all there is
    const auto place = [&](const std::string& path) { return std::filesystem::weakly_canonical(path, error); };
    if (one_stream || output == other || place(output) == place(other))
        throw Stop{ExitCode::usage, fmt::format("{} cannot hold two outputs at once", output), ""};
}

void print(std::string_view text) {
    Output out("-");
    out.write(text);
    out.finish();
}

void tell(std::string_view text) {
    // There is nowhere left to complain.
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    static_cast<void>(std::fflush(stderr));
}

}  // namespace pinfield::cli
