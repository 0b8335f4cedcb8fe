// Saving on a disk that fails, call by call: the table is the old one or the new one, and who was told "saved" has the new one.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "engine/io/files.h"
#include "tests/io/failing_calls.h"

using namespace pinfield;
using pinfield::test::FailingCalls;
using pinfield::test::Fault;

namespace {

namespace fs = std::filesystem;

/// A folder with a table and its .bak, anew.
struct Place {
    fs::path folder;
    std::string table;
    static inline const std::string older = "older", old_text = std::string(70'000, 'o'), new_text = std::string(90'000, 'n');

    Place() {
        std::string pattern = (fs::temp_directory_path() / "pinfield-saves-XXXXXX").string();
        folder = mkdtemp(pattern.data());
        table = (folder / "t.yaml").string();
        REQUIRE(write_file(table, old_text));
        fs::permissions(table, fs::perms::owner_read | fs::perms::owner_write);
        REQUIRE(write_file(backup_of(table), older));
    }
    ~Place() { fs::remove_all(folder); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }
    bool is_private() const { return fs::status(table).permissions() == (fs::perms::owner_read | fs::perms::owner_write); }
};

struct Tally {
    int saved = 0, refused = 0;
};

/// Saves while calls fail, and once more when they no longer do. Returns how many calls the first save made.
std::size_t save_twice(std::size_t nth, Fault fault, bool repeated, Tally& tally) {
    const Place place;
    Result<bool> saved(true);
    std::size_t made = 0;
    std::string failed;
    {
        const FailingCalls failing(nth, fault, repeated);
        saved = save_file(place.table, Place::new_text, Place::old_text);
        made = failing.made();
        failed = failing.failed();
    }
    INFO((repeated ? "every call " : "call ") << nth << " of " << made << ", fault " << static_cast<int>(fault) << ": " << failed << ": "
                                               << (saved ? "saved" : saved.error().message));
    (saved ? tally.saved : tally.refused) += 1;
    const std::string now = *read_file(place.table);
    const std::string backup = *read_file(backup_of(place.table));
    const bool whole = now == Place::new_text || (now == Place::old_text && !saved);
    const bool whole_backup = backup == Place::older || backup == Place::old_text;
    CHECK(whole);
    CHECK(whole_backup);
    CHECK(place.is_private());
    if (failed.find("unlink") == std::string::npos && !repeated) CHECK(place.files() == 2);
    if (!repeated && (fault == Fault::interrupted || fault == Fault::short_write)) CHECK(saved);
    CHECK(save_file(place.table, "later", now));
    CHECK(*read_file(place.table) == "later");
    CHECK(place.files() == 2);
    CHECK(place.is_private());
    return made;
}

}  // namespace

TEST_CASE("whichever system call of a save fails, the file is the old one or the new one, and nothing is left beside it") {
    for (const Fault fault : {Fault::io_error, Fault::disk_full, Fault::interrupted, Fault::short_write}) {
        Tally tally;
        std::size_t calls = 1;
        for (std::size_t nth = 1; nth <= calls; ++nth) calls = std::max(calls, save_twice(nth, fault, false, tally));
        CHECK(calls > 20);
        CHECK(tally.saved > 0);
        if (fault == Fault::io_error || fault == Fault::disk_full) CHECK(tally.refused > 5);
    }
}

TEST_CASE("nobody is told saved before the content, and then its name, are on the disk") {
    std::vector<std::string> calls;
    {
        const Place place;
        const FailingCalls none(0, Fault::io_error);
        REQUIRE(save_file(place.table, Place::new_text, Place::old_text));
        calls = none.calls();
    }
    const auto renamed = std::find(calls.rbegin(), calls.rend(), "rename");
    const auto content = std::find(renamed, calls.rend(), "fsync");
    const auto written = std::find(renamed, calls.rend(), "write");
    const auto name = std::find(calls.rbegin(), renamed, "fsync");
    REQUIRE(renamed != calls.rend());
    CHECK(content < written);  // seen from behind
    REQUIRE(name != renamed);
    for (const auto& sync : {content, name}) {
        const Place place;
        const FailingCalls failing(static_cast<std::size_t>(calls.rend() - sync), Fault::io_error);
        CHECK_FALSE(save_file(place.table, Place::new_text, Place::old_text));
        CHECK(failing.failed() == "fsync ");
    }
}

TEST_CASE("so it is when every second, third ... call fails") {
    for (const Fault fault : {Fault::io_error, Fault::disk_full, Fault::interrupted, Fault::short_write}) {
        Tally tally;
        for (std::size_t nth = 2; nth < 30; ++nth) save_twice(nth, fault, true, tally);
        if (fault == Fault::short_write) CHECK(tally.refused == 0);
        if (fault == Fault::io_error || fault == Fault::disk_full) CHECK(tally.refused > 5);
    }
}
