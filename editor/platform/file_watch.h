// When files are to be looked at again: soon after something happened to it, where the system tells (inotify on Linux); else now and then.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pinfield::editor {

/// All times are seconds since some start. A file need not be there, and may be a symbolic link: what happens to the link and to what it
/// stands for both count.
class FileWatch {
public:
    static constexpr double rest = 0.1;         ///< after the last thing that happened: whoever writes is then done
    static constexpr double patience = 0.5;     ///< after the first of them, however much more happens
    static constexpr double again = 0.6;        ///< after that look there is one more: a file that is replaced is gone for a moment
    static constexpr double poll_period = 0.5;  ///< where nobody tells
    static constexpr double slow_period = 10;   ///< where somebody does: what he may not know of, such as folders renamed further up

    /// `listens`: false where nothing but the given times may count.
    explicit FileWatch(bool listens = true);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// The file from now on; empty: none. The same one again changes nothing.
    void follow(const std::string& path) { follow(path.empty() ? std::vector<std::string>() : std::vector{path}); }
    /// Several, of which any counts.
    void follow(std::vector<std::string> paths);
    /// Are they to be looked at now?
    bool due(double now);
    /// Does the system tell? Not of files on other machines, nor where it has no watches left.
    bool hears() const { return !names_.empty(); }

private:
    void listen();
    bool anything_happened();
    void stop();

    int queue_ = -1;
    bool listens_ = true;
    bool is_lost_ = false;  ///< what is listened to is not where the file is any more
    std::vector<std::string> paths_;
    std::map<int, std::set<std::string>> names_;  ///< that matter in each folder, by its watch; empty: nobody tells
    double next_look_ = 0, first_ = -1, last_ = -1, second_look_ = -1;
};

}  // namespace pinfield::editor
