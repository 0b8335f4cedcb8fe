// Real files in real folders, looked at when something happens to them and not otherwise. Times are the test's own.
#include "editor/platform/file_watch.h"

#include <catch2/catch.hpp>

#include <filesystem>

#include "engine/io/files.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

namespace fs = std::filesystem;

/// A watch that has had its first look.
struct Watched {
    FileWatch watch;
    double now = 100;

    explicit Watched(const std::string& path) {
        watch.follow(path);
        CHECK(watch.hears());
        CHECK(watch.due(now));
        CHECK_FALSE(watch.due(now));
    }
    /// Whether there is a look within so many seconds, asked 100 times a second.
    bool looks_within(double seconds) {
        for (const double end = now + seconds; now < end; now += 0.01)
            if (watch.due(now)) return true;
        return false;
    }
    /// And the second look is had.
    bool notices() {
        const bool looked = looks_within(FileWatch::patience);
        return looked && looks_within(FileWatch::again + 0.05);
    }
};

}  // namespace

TEST_CASE("of several files that are watched, in whatever folders, any one counts") {
    const Folder folder;
    const std::string table = folder.write("table.yaml", "a");
    fs::create_directory(folder.file("parts"));
    const std::string part = folder.write("parts/walls.yaml", "a");
    FileWatch watch;
    double now = 100;
    const auto looks = [&] {
        for (const double end = now + FileWatch::patience + FileWatch::again; now < end; now += 0.01)
            if (watch.due(now)) return true;
        return false;
    };
    watch.follow({table, part});
    CHECK(watch.hears());
    CHECK(watch.due(now));
    CHECK_FALSE(looks());
    for (const std::string& file : {part, table}) {
        REQUIRE(write_file(file, "b"));
        CHECK(looks());
        CHECK(looks());
        CHECK_FALSE(looks());
    }
    watch.follow(table);
    REQUIRE(write_file(part, "c"));
    CHECK_FALSE(looks());
}

TEST_CASE("a watched file is looked at when it was written, replaced, moved away or removed, and once more after that") {
    const Folder folder;
    const std::string table = folder.write("table.yaml", "a");
    Watched watched(table);
    CHECK_FALSE(watched.looks_within(2));
    folder.write("table.yaml", "b");
    CHECK(watched.notices());
    CHECK_FALSE(watched.looks_within(2));
    REQUIRE(write_file(table, "c"));
    CHECK(watched.notices());
    fs::rename(table, folder.file("elsewhere.yaml"));
    CHECK(watched.notices());
    fs::rename(folder.file("elsewhere.yaml"), table);
    CHECK(watched.notices());
    fs::remove(table);
    CHECK(watched.notices());
    folder.write("table.yaml", "d");
    CHECK(watched.notices());
    fs::remove(table);
    fs::create_hard_link(folder.write("other.yaml", "e"), table);
    CHECK(watched.notices());
    CHECK_FALSE(watched.looks_within(2));
}

TEST_CASE("what happens to other files of the folder is no reason to look") {
    const Folder folder;
    Watched watched(folder.write("table.yaml", "a"));
    folder.write("table.yaml.bak", "b");
    folder.write("another.yaml", "b");
    fs::remove(folder.file("another.yaml"));
    CHECK_FALSE(watched.looks_within(2));
}

TEST_CASE("a file that is written again and again is looked at when it rests, and at the latest after half a second") {
    const Folder folder;
    Watched watched(folder.write("table.yaml", "a"));
    folder.write("table.yaml", "b");
    CHECK_FALSE(watched.looks_within(0.05));
    folder.write("table.yaml", "c");
    CHECK_FALSE(watched.looks_within(0.09));
    CHECK(watched.looks_within(0.03));
    CHECK(watched.looks_within(FileWatch::again + 0.05));
    int looks = 0;
    for (int i = 0; i < 20; ++i) {
        folder.write("table.yaml", std::string(static_cast<std::size_t>(i), 'x'));
        looks += watched.looks_within(0.05);
    }
    CHECK(looks >= 1);
    CHECK(looks <= 4);
}

TEST_CASE("of a symbolic link both ends count, and another end is followed") {
    const Folder links, tables;
    const std::string link = links.file("table.yaml");
    fs::create_symlink(tables.write("real.yaml", "a"), links.file("middle.yaml"));
    fs::create_symlink("middle.yaml", link);
    Watched watched(link);
    tables.write("real.yaml", "b");
    CHECK(watched.notices());
    REQUIRE(write_file(link, "c"));
    CHECK(tables.read("real.yaml") == "c");
    CHECK(watched.notices());
    tables.write("second.yaml", "d");
    CHECK_FALSE(watched.looks_within(2));
    fs::create_symlink(tables.file("second.yaml"), links.file("new.yaml"));
    fs::rename(links.file("new.yaml"), link);
    CHECK(watched.notices());
    tables.write("second.yaml", "e");
    CHECK(watched.notices());
    tables.write("real.yaml", "f");
    CHECK_FALSE(watched.looks_within(2));
}

TEST_CASE("where nobody tells, the file is looked at twice a second, and is heard of again when its folder is back") {
    const Folder folder;
    fs::create_directory(folder.file("tables"));
    const std::string table = folder.write("tables/table.yaml", "a");
    FileWatch deaf(false);
    deaf.follow(table);
    CHECK_FALSE(deaf.hears());
    int looks = 0;
    for (int i = 0; i < 160; ++i) looks += deaf.due(i / 16.0);
    CHECK(looks == 20);

    Watched watched(table);
    fs::rename(folder.file("tables"), folder.file("away"));
    CHECK(watched.looks_within(FileWatch::patience));
    CHECK_FALSE(watched.watch.hears());
    CHECK(watched.looks_within(FileWatch::poll_period + 0.1));
    fs::rename(folder.file("away"), folder.file("tables"));
    CHECK(watched.looks_within(FileWatch::poll_period + 0.1));
    CHECK(watched.watch.hears());
    folder.write("tables/table.yaml", "b");
    CHECK(watched.looks_within(FileWatch::patience));
}

TEST_CASE("no file is never looked at") {
    FileWatch watch;
    watch.follow("");
    CHECK_FALSE(watch.due(0));
    CHECK_FALSE(watch.due(1e6));
}
