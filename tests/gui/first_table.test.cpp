// The table of docs/first-table.md, made in the real window with mouse and keys alone.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/places.h"

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

int exit_code(const fs::path& folder, const std::string& command) {
    const int status = std::system(("cd '" + folder.string() + "' && " + command + " > out.txt 2>&1").c_str());
    INFO(read(folder / "out.txt"));
    CHECK(WIFEXITED(status));
    return WEXITSTATUS(status);
}

}  // namespace

TEST_CASE("a first table is made from New to saved and played by mouse and keys alone, as docs/first-table.md tells") {
    const fs::path docs = fs::path(pinfield::test::source_dir()) / "docs/first-table";
    std::string pattern = (fs::temp_directory_path() / "pinfield-first-XXXXXX").string();
    const fs::path folder = mkdtemp(pattern.data());
    fs::copy(docs / "steps.yaml", folder / "steps.yaml");
    const std::string steps = read(folder / "steps.yaml");
    for (const char* other : {"{set:", "{insert:", "{action:", "{select:", "{paste:"}) CHECK(steps.find(other) == std::string::npos);
    CHECK(exit_code(folder, pinfield::test::bin_dir() + "/pinfield-editor --script steps.yaml --size 1280x800") == 0);
    INFO(read(folder / "out.txt"));
    CHECK(read(folder / "my_table.yaml") == read(docs / "my_table.yaml"));
    CHECK(exit_code(folder, pinfield::test::bin_dir() + "/pinfield check my_table.yaml") == 0);
    CHECK(exit_code(folder, pinfield::test::bin_dir() + "/pinfield test my_table.yaml") == 0);
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(docs))
        if (entry.path().extension() == ".png") pictures += fs::exists(folder / entry.path().filename());
    CHECK(pictures >= 6);
    fs::remove_all(folder);
}
