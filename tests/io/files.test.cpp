#include "engine/io/files.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <thread>
#include <fstream>
#include <iterator>

#include "engine/io/png.h"

using namespace pinfield;
namespace fs = std::filesystem;

namespace {

/// A folder that goes away with the test.
struct Folder {
    fs::path path;
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "pinfield-files-XXXXXX").string();
        path = mkdtemp(pattern.data());
    }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string file(const char* name) const { return (path / name).string(); }
    std::size_t count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

}  // namespace

TEST_CASE("what is written is what is read, byte for byte") {
    const Folder folder;
    const std::string bytes("a\r\nb\0c\xFF", 7);
    REQUIRE(write_file(folder.file("a"), bytes));
    CHECK(*read_file(folder.file("a")) == bytes);
    CHECK(folder.count() == 1);
}

TEST_CASE("a file larger than the limit is not read") {
    const Folder folder;
    REQUIRE(write_file(folder.file("a"), std::string(1000, 'x')));
    CHECK(read_file(folder.file("a"), 1000));
    CHECK_FALSE(read_file(folder.file("a"), 999));
    CHECK_FALSE(read_file_start(folder.file("a"), 999)->whole);
    CHECK_FALSE(read_file(folder.path.string()));
    CHECK_FALSE(read_file("/dev/zero"));
}

TEST_CASE("saving keeps the previous content beside the file") {
    const Folder folder;
    REQUIRE(save_file(folder.file("t.yaml"), "one", std::nullopt));
    REQUIRE(save_file(folder.file("t.yaml"), "two", "one"));
    CHECK(*read_file(folder.file("t.yaml")) == "two");
    CHECK(*read_file(backup_of(folder.file("t.yaml"))) == "one");
    CHECK(folder.count() == 2);
}

TEST_CASE("saving refuses when the disk no longer holds what was loaded") {
    const Folder folder;
    REQUIRE(write_file(folder.file("t.yaml"), "theirs"));
    CHECK_FALSE(save_file(folder.file("t.yaml"), "mine", "loaded"));
    CHECK_FALSE(save_file(folder.file("t.yaml"), "mine", std::nullopt));
    CHECK_FALSE(save_file(folder.file("gone.yaml"), "mine", "loaded"));
    CHECK(*read_file(folder.file("t.yaml")) == "theirs");
}

TEST_CASE("saving through a symbolic link replaces what it points at and keeps the permissions") {
    const Folder folder;
    REQUIRE(write_file(folder.file("real.yaml"), "one"));
    fs::permissions(folder.file("real.yaml"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.yaml", folder.file("link.yaml"));
    REQUIRE(save_file(folder.file("link.yaml"), "two", "one"));
    CHECK(fs::is_symlink(folder.file("link.yaml")));
    CHECK(*read_file(folder.file("real.yaml")) == "two");
    CHECK(fs::status(folder.file("real.yaml")).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("a backup is as private as the table, follows no link and stands in nobody's way") {
    const Folder folder;
    const std::string table = folder.file("t.yaml"), backup = backup_of(table);
    REQUIRE(write_file(table, "one"));
    const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
    fs::permissions(table, own);
    SECTION("private") {
        REQUIRE(save_file(table, "two", "one"));
        CHECK(fs::status(backup).permissions() == own);
    }
    SECTION("a link") {
        REQUIRE(write_file(folder.file("precious"), "precious"));
        fs::create_symlink("precious", backup);
        REQUIRE(save_file(table, "two", "one"));
        CHECK(*read_file(folder.file("precious")) == "precious");
        CHECK(*read_file(backup) == "one");
        CHECK_FALSE(fs::is_symlink(backup));
    }
    SECTION("a folder of its name") {
        fs::create_directory(backup);
        REQUIRE(save_file(table, "two", "one"));
        CHECK(*read_file(table) == "two");
        CHECK(folder.count() == 2);
    }
    SECTION("a name that leaves no room for .bak") {
        const std::string longest = folder.file(std::string(255, 'n').c_str());
        REQUIRE(save_file(longest, "one", std::nullopt));
        REQUIRE(save_file(longest, "two", "one"));
        CHECK(*read_file(longest) == "two");
    }
}

TEST_CASE("what an author calls .bak is never touched") {
    const Folder folder;
    REQUIRE(write_file(folder.file("t.yaml"), "one"));
    REQUIRE(write_file(folder.file("t.yaml.bak"), "my own copy"));
    REQUIRE(save_file(folder.file("t.yaml"), "two", "one"));
    CHECK(*read_file(folder.file("t.yaml.bak")) == "my own copy");
}

TEST_CASE("what another program, which asks for no lock, puts in a file's place during a save is never lost") {
    const Folder folder;
    const std::string table = folder.file("t.yaml"), theirs = folder.file("theirs");
    int refused = 0;
    for (int round = 0; round < 300; ++round) {
        REQUIRE(write_file(table, "old"));
        std::ofstream(theirs) << "theirs";
        std::thread other([&] {
            for (int spin = 0; spin < 40 * (round % 60); ++spin) std::this_thread::yield();
            fs::rename(theirs, table);
        });
        const bool saved = save_file(table, "mine", "old").has_value();
        other.join();
        refused += saved ? 0 : 1;
        // Theirs came last and stays, or came before mine, which then was refused: in no case is it gone.
        REQUIRE(*read_file(table) == "theirs");
    }
    CHECK(refused <= 300);
}

TEST_CASE("a read-only file is not replaced") {
    const Folder folder;
    const std::string table = folder.file("t.yaml");
    REQUIRE(write_file(table, "one"));
    fs::permissions(table, fs::perms::owner_read);
    const auto saved = save_file(table, "two", "one");
    REQUIRE_FALSE(saved);
    CHECK(saved.error().message.find("read-only") != std::string::npos);
    CHECK_FALSE(write_file(table, "two"));
    CHECK(*read_file(table) == "one");
    CHECK(folder.count() == 1);
}

TEST_CASE("a link to nothing is not replaced") {
    const Folder folder;
    fs::create_symlink("nowhere.yaml", folder.file("t.yaml"));
    CHECK_FALSE(save_file(folder.file("t.yaml"), "mine", std::nullopt));
    CHECK_FALSE(write_file(folder.file("t.yaml"), "mine"));
    CHECK(fs::is_symlink(folder.file("t.yaml")));
}

TEST_CASE("what a process that died left of a save is cleared away by the next one") {
    const Folder folder;
    REQUIRE(write_file(folder.file("t.yaml"), "one"));
    REQUIRE(write_file(folder.file(".t.yaml.saving-0"), "hal"));
    REQUIRE(write_file(folder.file(".other.yaml.saving-0"), "of another"));
    REQUIRE(write_file(folder.file("t.yaml"), "two"));
    CHECK_FALSE(fs::exists(folder.file(".t.yaml.saving-0")));
    CHECK(fs::exists(folder.file(".other.yaml.saving-0")));
}

TEST_CASE("of two who save over the same text at once, one is refused") {
    const Folder folder;
    const std::string table = folder.file("t.yaml");
    REQUIRE(write_file(table, "0"));
    int both = 0;
    for (int round = 0; round < 60; ++round) {
        const std::string before = *read_file(table);
        bool saved[2] = {};
        std::thread threads[2];
        for (int i = 0; i < 2; ++i)
            threads[i] = std::thread([&, i] { saved[i] = save_file(table, std::to_string(10 * round + 10 + i), before).has_value(); });
        for (std::thread& thread : threads) thread.join();
        CHECK(saved[0] != saved[1]);
        CHECK(*read_file(table) == std::to_string(10 * round + 10 + (saved[1] ? 1 : 0)));
        both += saved[0] && saved[1];
    }
    CHECK(both == 0);
}

TEST_CASE("a folder that is not there is a failure with its name") {
    const auto result = write_file("/nonexistent/t.yaml", "x");
    REQUIRE_FALSE(result);
    CHECK(result.error().message.find("/nonexistent/t.yaml") != std::string::npos);
}

TEST_CASE("a picture is a PNG of its size") {
    const Folder folder;
    REQUIRE(write_png(folder.file("a.png"), 3, 2, std::vector<unsigned char>(18, 200)));
    const std::string bytes = *read_file(folder.file("a.png"));
    CHECK(bytes.substr(1, 3) == "PNG");
    CHECK(bytes[19] == 3);
    CHECK(bytes[23] == 2);
    CHECK_FALSE(write_png(folder.file("b.png"), 3, 2, std::vector<unsigned char>(17)));
    CHECK_FALSE(write_png(folder.file("b.png"), 0, 0, {}));
}
