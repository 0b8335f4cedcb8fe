#include "editor/platform/native_dialog.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace pinfield::editor {
namespace {

std::string_view variable(const char* name) {
    const char* const text = std::getenv(name);
    return text ? text : "";
}

std::vector<std::string> arguments_of(const DialogWords& asked, const std::string& at) {
    std::vector<std::string> out{"zenity",
                                 "--file-selection",
                                 "--title=" + asked.title,
                                 "--filename=" + at,
                                 "--file-filter=" + asked.files + " | " + asked.patterns,
                                 "--file-filter=All files | *"};
    if (asked.saves) out.insert(out.end(), {"--save", "--confirm-overwrite"});
    return out;
}

/// In the child: nothing but what is allowed between fork() and exec(). Of the parent's files it keeps none but its output.
[[noreturn]] void become(const char* program, char* const* arguments, int output) {
    ::dup2(output, STDOUT_FILENO);
    ::execv(program, arguments);
    ::_exit(127);
}

}  // namespace

std::string program_called(const std::string& name) {
    std::string_view folders = variable("PATH");
    while (!folders.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        const std::string file = std::string(folders.substr(0, end)) + "/" + name;
        if (file.front() == '/' && ::access(file.c_str(), X_OK) == 0) return file;
        folders.remove_prefix(std::min(end + 1, folders.size()));
    }
    return {};
}

NativeDialog::~NativeDialog() { close(); }

bool NativeDialog::open(const DialogWords& asked, const std::string& at) {
    close();
    path_.clear();
    const std::string program = program_called("zenity");
    if (program.empty() || (variable("DISPLAY").empty() && variable("WAYLAND_DISPLAY").empty())) return false;
    std::vector<std::string> words = arguments_of(asked, at);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    child_ = ::fork();
    if (child_ == 0) become(program.c_str(), arguments.data(), ends[1]);
    ::close(ends[1]);
    output_ = ends[0];
    if (child_ < 0) return forget(), false;
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
    return true;
}

NativeDialog::State NativeDialog::poll() {
    if (child_ < 0) return State::none;
    std::array<char, 4096> buffer{};
    ssize_t count = 0;
    while ((count = ::read(output_, buffer.data(), buffer.size())) > 0) path_.append(buffer.data(), static_cast<std::size_t>(count));
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return State::waiting;
    int status = 0;
    if (::waitpid(child_, &status, WNOHANG) == 0) return State::waiting;
    forget();
    while (!path_.empty() && (path_.back() == '\n' || path_.back() == '\r')) path_.pop_back();
    constexpr int somebody_cancelled = 1;
    if (!WIFEXITED(status)) return State::failed;
    if (WEXITSTATUS(status) == somebody_cancelled) return State::cancelled;
    return WEXITSTATUS(status) == 0 && !path_.empty() ? State::chosen : State::failed;
}

void NativeDialog::close() {
    if (child_ < 0) return;
    ::kill(child_, SIGKILL);  // whoever has not yet become the program has this one's handlers
    ::waitpid(child_, nullptr, 0);
    forget();
}

void NativeDialog::forget() {
    if (output_ >= 0) ::close(output_);
    child_ = output_ = -1;
}

}  // namespace pinfield::editor
