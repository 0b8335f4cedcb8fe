// The desktop's own file dialog, through zenity where that is installed: a program beside this one, which is asked now and then whether
// somebody has chosen. It is found when it is needed, and nothing needs it.
#pragma once
#include <string>

namespace pinfield::editor {

/// What it says, and which files it lists.
struct DialogWords {
    std::string title;     ///< "Open a table"
    std::string files;     ///< "Tables"
    std::string patterns;  ///< "*.yaml *.yml"
    bool saves = false;    ///< the file may be a new one
};

class NativeDialog {
public:
    enum class State : unsigned char { none, waiting, chosen, cancelled, failed };

    NativeDialog() = default;
    ~NativeDialog();
    NativeDialog(const NativeDialog&) = delete;
    NativeDialog& operator=(const NativeDialog&) = delete;

    /// Opens it where `at` is, a folder or a file. False where there is no such program, or no desktop to show it on.
    bool open(const DialogWords& words, const std::string& at);
    /// After chosen, path() is the file; after any answer there is no dialog any more.
    State poll();
    const std::string& path() const { return path_; }
    /// Closes it without an answer.
    void close();

private:
    void forget();

    int child_ = -1, output_ = -1;
    std::string path_;
};

/// The first file of that name that may be run, in the folders of $PATH; empty: there is none.
std::string program_called(const std::string& name);

}  // namespace pinfield::editor
