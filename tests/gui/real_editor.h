// The real editor in a folder of its own, run as a command; what it said and what it wrote. Needs a display.
#pragma once
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/places.h"

namespace pinfield::test {

namespace fs = std::filesystem;

inline std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// A folder with a copy of a table, gone at the end.
struct Workplace {
    fs::path folder;

    explicit Workplace(const fs::path& original = fs::path(source_dir()) / "scenes/tables/first_table.yaml") {
        std::string pattern = (fs::temp_directory_path() / "pinfield-gui-XXXXXX").string();
        folder = mkdtemp(pattern.data());
        fs::copy_file(original, table());
    }
    ~Workplace() { fs::remove_all(folder); }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    fs::path table() const { return folder / "table.yaml"; }
    fs::path in(const std::string& name) const { return folder / name; }
};

struct Outcome {
    int code = -1;
    std::string said;  ///< stdout and stderr
};

/// A command of the shell, in the folder.
inline Outcome run_command(const Workplace& place, const std::string& command) {
    const fs::path log = place.in("log.txt");
    const int status = std::system(("cd '" + place.folder.string() + "' || exit; { " + command + "; } > '" + log.string() + "' 2>&1").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(log)};
}

/// `after`: shell code behind the editor's command.
inline Outcome run_editor(const Workplace& place, const std::string& arguments, const std::string& after = {}) {
    return run_command(place, "'" + bin_dir() + "/pinfield-editor' " + arguments + after);
}

/// A script over table.yaml.
inline Outcome run_script(const Workplace& place, const std::string& steps) {
    write(place.in("steps.yaml"), steps);
    return run_editor(place, "table.yaml --script steps.yaml --size 1280x800");
}

}  // namespace pinfield::test
