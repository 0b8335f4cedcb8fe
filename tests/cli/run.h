// Runs the real executable, as a shell would.
#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places.h"

namespace pinfield::cli_test {

inline std::string slurp(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A folder of its own, gone afterwards.
class Scratch {
public:
    Scratch() {
        std::string pattern = (std::filesystem::temp_directory_path() / "pinfield-cli-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return *this / name;
    }

private:
    std::filesystem::path path_;
};

struct Outcome {
    int exit = -1;  ///< the exit code; 128 + signal when it crashed
    std::string out, err;
};

/// `arguments` as one would type them (the shell splits them); `redirect` may send stdout elsewhere.
inline Outcome run_pinfield(const std::string& arguments, const std::string& redirect = "") {
    const Scratch scratch;
    const std::string out = scratch / "out", err = scratch / "err";
    const std::string command = std::string("cd ") + pinfield::test::source_dir() + " && " + pinfield::test::bin_dir() + "/pinfield " +
                                arguments + " >" + (redirect.empty() ? out : redirect) + " 2>" + err + " </dev/null";
    const int status = std::system(command.c_str());
    const int exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {exit, slurp(out), slurp(err)};
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

inline const std::string first_table = "scenes/tables/first_table.yaml";

}  // namespace pinfield::cli_test
