#include "engine/io/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <utility>

#include "engine/io/files_replaced.h"

namespace pinfield {

struct OutputFile::State {
    std::filesystem::path target;
    std::string path, waiting{};
    Replacement replacement;

    State(std::filesystem::path where, const std::string& name, const FileStatus& like)
        : target(std::move(where)), path(name), replacement(target, name, like) {}

    Result<bool> flush() {
        Result<bool> written = replacement.write(waiting);
        waiting.clear();
        return written;
    }
};

OutputFile::OutputFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

Result<OutputFile> OutputFile::open(const std::string& path) {
    std::filesystem::path target = real_target(path);
    const Result<FileStatus> status = status_of(target, path);
    if (!status) return tl::unexpected<Failure>(status.error());
    auto state = std::make_unique<State>(std::move(target), path, *status);
    // A file without a name gets one by way of /proc; by the end it would be too late to find that missing.
    const Result<bool> begun = state->replacement.begin(::access("/proc/self/fd", X_OK) == 0);
    if (!begun) return tl::unexpected<Failure>(begun.error());
    return OutputFile(std::move(state));
}

Result<bool> OutputFile::write(std::string_view bytes) {
    constexpr std::size_t enough = 1 << 16;
    state_->waiting += bytes;
    return state_->waiting.size() < enough ? Result<bool>(true) : state_->flush();
}

Result<bool> OutputFile::finish() {
    if (const auto flushed = state_->flush(); !flushed) return flushed;
    FolderLock lock(state_->target);
    if (lock.busy()) return busy_folder(state_->path);
    if (lock.held()) clear_strays(state_->target);
    if (const auto ready = state_->replacement.ready(); !ready) return ready;
    return state_->replacement.put_in_place(lock);
}

bool is_stream(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status);
}

void hold_standard_streams() {
    for (int stream = 0; stream <= 2; ++stream)  // the lowest free number is the one that open() gives
        if (::fcntl(stream, F_GETFD) == -1 && ::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY) != stream) return;
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN);
#endif
}

}  // namespace pinfield
