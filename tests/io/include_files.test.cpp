// Included files on a real disk: links, pipes, folders, files that go away. Nothing outside the table's folder is read, and nothing waits.
#include <catch2/catch.hpp>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "engine/io/files_below.h"
#include "engine/io/load_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

namespace fs = std::filesystem;

class Folder {
public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "pinfield-include-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
        fs::create_directories(path_ / "tables/parts");
        write("secret.yaml", "pinfield: 1\nscene: [circle: {id: secret}]\n");
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path operator/(const std::string& name) const { return path_ / name; }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name, std::ios::binary) << text; }

    /// What is said of a table in tables/ that includes these, and nothing of where the folder is.
    std::string told_of(const std::string& list) const {
        write("tables/table.yaml", "pinfield: 1\ninclude: [" + list + "]\nscene: [circle: {}]\n");
        const Result<Reading> reading = load_table((path_ / "tables/table.yaml").string(), catalog());
        REQUIRE(reading);
        std::string out;
        for (const Diagnostic& found : reading->diagnostics) out += found.code + " " + found.message + "\n";
        const std::string here = (path_ / "tables/").string();
        for (std::size_t at = out.find(here); at != std::string::npos; at = out.find(here)) out.erase(at, here.size());
        CHECK_FALSE(reading->scene.find("secret"));
        return out;
    }

private:
    fs::path path_;
};

const std::string some_part = "pinfield: 1\nscene: [box: {size: [1cm, 1cm]}]\n";

}  // namespace

TEST_CASE("a table on the disk has what the files beside it say") {
    const Folder folder;
    folder.write("tables/parts/a.yaml", some_part);
    CHECK(folder.told_of("parts/a.yaml, ./parts/../parts/a.yaml").empty());
    const Reading reading = *load_table((folder / "tables/table.yaml").string(), catalog());
    CHECK(reading.scene.roots().size() == 2);
    CHECK(reading.scene.sources.all()[1]->name() == (folder / "tables/parts/a.yaml").string());
}

TEST_CASE("a table that is named without a folder has the files of the folder the program was started in") {
    const Folder folder;
    folder.write("tables/parts/a.yaml", some_part);
    folder.write("tables/table.yaml", "pinfield: 1\ninclude: [parts/a.yaml]\n");
    const fs::path before = fs::current_path();
    fs::current_path(folder / "tables");
    const Result<Reading> here = load_table("table.yaml", catalog());
    fs::current_path(folder / "tables/parts");
    const Result<Reading> above = load_table("../table.yaml", catalog());
    fs::current_path(before);
    for (const Result<Reading>* reading : {&here, &above}) {
        REQUIRE(*reading);
        CHECK((*reading)->diagnostics.empty());
        CHECK((*reading)->scene.roots().size() == 1);
    }
}

TEST_CASE("links within the table's folder are ways to their files, and lead nowhere out of it") {
    const Folder folder;
    folder.write("tables/parts/a.yaml", some_part);
    fs::create_symlink("a.yaml", folder / "tables/parts/same.yaml");
    fs::create_directory_symlink("parts", folder / "tables/other");
    CHECK(folder.told_of("parts/a.yaml, parts/same.yaml, other/a.yaml, other/same.yaml").empty());
    CHECK(load_table((folder / "tables/table.yaml").string(), catalog())->scene.roots().size() == 2);

    fs::create_symlink("../secret.yaml", folder / "tables/out.yaml");
    fs::create_symlink("/etc/passwd", folder / "tables/passwd");
    fs::create_directory_symlink("..", folder / "tables/up");
    fs::create_symlink("loop.yaml", folder / "tables/loop.yaml");
    fs::create_symlink("nowhere.yaml", folder / "tables/dangling.yaml");
    CHECK(folder.told_of("out.yaml, passwd, up/secret.yaml, loop.yaml, dangling.yaml") ==
          "E0308 out.yaml is a link that leads out of the table's folder\n"
          "E0308 passwd is a link that leads out of the table's folder\n"
          "E0308 up/secret.yaml is a link that leads out of the table's folder\n"
          "E0308 cannot open loop.yaml: Too many levels of symbolic links\n"
          "E0308 cannot open dangling.yaml: No such file or directory\n");
}

TEST_CASE("a table that is itself a link includes what stands beside the link") {
    const Folder folder;
    folder.write("tables/parts/a.yaml", some_part);
    folder.write("real.yaml", "pinfield: 1\ninclude: [parts/a.yaml]\n");
    fs::create_symlink("../real.yaml", folder / "tables/link.yaml");
    CHECK(load_table((folder / "tables/link.yaml").string(), catalog())->diagnostics.empty());
    CHECK_FALSE(load_table((folder / "real.yaml").string(), catalog())->ok());
}

TEST_CASE("what is no ordinary file is refused at once, and never waited for") {
    const Folder folder;
    folder.write("tables/closed.yaml", some_part);
    fs::permissions(folder / "tables/closed.yaml", fs::perms::none);
    REQUIRE(::mkfifo((folder / "tables/pipe.yaml").c_str(), 0600) == 0);
    const auto begin = std::chrono::steady_clock::now();
    CHECK(folder.told_of("parts, pipe.yaml, parts/none.yaml, none/a.yaml, table.yaml/a.yaml") ==
          "E0308 cannot read parts: it is no ordinary file\n"
          "E0308 cannot read pipe.yaml: it is no ordinary file\n"
          "E0308 cannot open parts/none.yaml: No such file or directory\n"
          "E0308 cannot open none/a.yaml: No such file or directory\n"
          "E0308 cannot open table.yaml/a.yaml: Not a directory\n");
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(1));
    if (::geteuid() != 0) CHECK(folder.told_of("closed.yaml") == "E0308 cannot open closed.yaml: Permission denied\n");  // root may read all
    const std::string long_name(300, 'a');
    CHECK(folder.told_of(long_name) == "E0308 cannot open " + long_name + ": File name too long\n");
}

TEST_CASE("a file that goes away or turns into something else is an error and no crash") {
    const Folder folder;
    const std::string tables = (folder / "tables").string() + "/";
    folder.write("tables/a.yaml", some_part);
    fs::create_directory(folder / "tables/deep");
    folder.write("tables/deep/a.yaml", some_part);
    CHECK(read_below(tables, "deep/a.yaml", 1000));
    fs::rename(folder / "tables/deep", folder / "tables/gone");
    CHECK_FALSE(read_below(tables, "deep/a.yaml", 1000));
    fs::create_directory_symlink("gone", folder / "tables/deep");
    CHECK(read_below(tables, "deep/a.yaml", 1000)->path == "gone/a.yaml");
    CHECK(read_below(tables, "a.yaml", 4)->text == some_part.substr(0, 4));
    CHECK_FALSE(read_below((folder / "no_such").string() + "/", "a.yaml", 1000));
}

TEST_CASE("a folder that somebody changes for a link out of the table's, again and again, never gives what is there") {
    const Folder folder;
    const std::string tables = (folder / "tables").string() + "/";
    const fs::path way = folder / "tables/deep", real = folder / "tables/real";
    fs::create_directory(way);
    folder.write("tables/deep/secret.yaml", some_part);
    std::atomic<bool> done = false;
    std::thread somebody([&] {
        while (!done) {
            fs::rename(way, real);
            fs::create_directory_symlink(folder / "", way);
            fs::remove(way);
            fs::rename(real, way);
        }
    });
    int read = 0, refused = 0, wrong = 0;
    for (int i = 0; i < 3000 || ((read == 0 || refused == 0) && i < 1'000'000); ++i) {  // a busy machine runs one of both alone for long
        const Result<FoundFile> found = read_below(tables, "deep/secret.yaml", 1000);
        ++(found ? read : refused);
        wrong += found && found->text != some_part ? 1 : 0;
    }
    done = true;
    somebody.join();
    CHECK(wrong == 0);
    CHECK(read > 0);
    CHECK(refused > 0);
}

TEST_CASE("64 files and 32 MiB are read, and not one file or byte more") {
    const Folder folder;
    std::string list;
    for (int i = 1; i <= 65; ++i) {
        folder.write(fmt::format("tables/p{}.yaml", i), "pinfield: 1\n");
        list += fmt::format("{}p{}.yaml", i == 1 ? "" : ", ", i);
        if (i == 64) CHECK(folder.told_of(list).empty());
    }
    CHECK(folder.told_of(list) == "E0126 more than 64 files\n");

    const Limits limits;
    list = "p1.yaml, p2.yaml, p3.yaml, p4.yaml, p5.yaml, p6.yaml, p7.yaml, p8.yaml, p9.yaml, p10.yaml, p11.yaml, p12.yaml, p13.yaml, p14.yaml, p15.yaml, p16.yaml";
    const std::size_t main_size = ("pinfield: 1\ninclude: [" + list + "]\nscene: [circle: {}]\n").size();
    const auto commented = [](std::size_t size) {  // with values in between: no comment is longer than 1 MiB
        const std::string ends = "pinfield: 1\n\ninputs: {}\n\n";
        const std::size_t half = size / 2;
        return "pinfield: 1\n" + std::string(half, '#') + "\ninputs: {}\n" + std::string(size - half - ends.size(), '#') + "\n";
    };
    for (int i = 1; i <= 16; ++i) folder.write(fmt::format("tables/p{}.yaml", i), commented(limits.file_bytes));
    folder.write("tables/p16.yaml", commented(limits.table_bytes - main_size - 15 * limits.file_bytes));
    const auto begin = std::chrono::steady_clock::now();
    CHECK(folder.told_of(list).empty());
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
    folder.write("tables/p16.yaml", commented(limits.table_bytes - main_size - 15 * limits.file_bytes + 1));
    CHECK(folder.told_of(list) == fmt::format("E0127 the table's files together are larger than {} bytes\n", limits.table_bytes));
    folder.write("tables/p1.yaml", commented(limits.file_bytes + 1));
    CHECK(folder.told_of("p1.yaml") == fmt::format("E0106 p1.yaml is larger than {} bytes\n", limits.file_bytes));
}

TEST_CASE("templates that use each other twice across files end at the limit of nodes") {
    const Folder folder;
    std::string list;
    for (int i = 0; i < 60; ++i) {
        const std::string next = i == 59 ? "circle: {}" : fmt::format("use: {{template: t{}}}", i + 1);
        folder.write(fmt::format("tables/p{}.yaml", i),
                     fmt::format("pinfield: 1\n{}templates: {{t{}: {{nodes: [{}, {}]}}}}\n", i == 59 ? "" : fmt::format("include: [p{}.yaml]\n", i + 1), i, next, next));
    }
    folder.write("tables/all.yaml", "pinfield: 1\ninclude: [p0.yaml]\nscene: [use: {template: t0}]\n");
    const Reading reading = *load_table((folder / "tables/all.yaml").string(), catalog());
    REQUIRE(reading.diagnostics.size() == 1);
    CHECK(reading.diagnostics.front().code == "E0110");
}

TEST_CASE("a hundred ways between files that include each other are a circle or nothing") {
    const Folder folder;
    std::string all;
    for (int i = 0; i < 60; ++i) all += fmt::format("{}p{}.yaml", i == 0 ? "" : ", ", i);
    for (int i = 0; i < 60; ++i) folder.write(fmt::format("tables/p{}.yaml", i), "pinfield: 1\ninclude: [" + all + "]\n");
    const auto begin = std::chrono::steady_clock::now();
    const std::string told = folder.told_of("p0.yaml");
    CHECK(told.starts_with("E0231 files include each other in a circle: p0.yaml -> p0.yaml\n"));
    CHECK(std::count(told.begin(), told.end(), '\n') <= 101);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(1));
}
