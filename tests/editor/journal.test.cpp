// Journals as files: cut, damaged, locked, and left by processes that were killed.
#include "editor/journal.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <optional>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

namespace fs = std::filesystem;

/// The n-th state of some table: its text grows and shrinks.
UnsavedWork work_of(int n) {
    std::string text = "pinfield: 1\nscene:\n";
    for (int i = 0; i <= n % 7; ++i) text += "  - circle: {radius: " + std::to_string(n) + "mm}\n";
    return {"/tables/pen.yaml", "pinfield: 1\n", text, n, "Edit " + std::to_string(n), 1'000'000 + n};
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

mode_t mode_of(const std::string& path) {
    struct stat status {};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    return status.st_mode & 0777;
}

}  // namespace

TEST_CASE("what a journal was told last is found once its editor is gone, and nothing before") {
    const Folder folder;
    const std::string place = folder.file("state/pinfield");
    {
        Journal journal(place);
        for (int n = 0; n < 5; ++n) REQUIRE(journal.write(work_of(n)));
        REQUIRE(journal.sync());
        CHECK(find_orphans(place).found.empty());  // it lives
        CHECK(mode_of(place) == 0700);
        CHECK(mode_of(journal.path()) == 0600);
    }
    const Orphans orphans = find_orphans(place);
    REQUIRE(orphans.found.size() == 1);
    CHECK(orphans.found[0].work == work_of(4));
    CHECK(orphans.unreadable.empty());
    CHECK(remove_orphan(orphans.found[0].file));
    CHECK_FALSE(remove_orphan(orphans.found[0].file));
    CHECK(names_in(place).empty());
}

TEST_CASE("texts come back byte by byte") {
    UnsavedWork work = work_of(3);
    work.text = std::string("\xEF\xBB\xBF# caf\xC3\xA9\r\nnul: ") + '\0' + "\n" + journal_head() + journal_record(work_of(9)) + "\nrecord ";
    work.table.clear();
    work.last_label = "Move \"pop\"\n";
    const JournalContent content = read_journal(journal_head() + journal_record(work_of(1)) + journal_record(work));
    REQUIRE(content.state == JournalContent::State::whole);
    CHECK(content.work == work);
}

TEST_CASE("a dropped journal leaves no file, and the next write begins another") {
    const Folder folder;
    Journal journal(folder.file("state"));
    journal.drop();
    REQUIRE(journal.write(work_of(1)));
    journal.drop();
    CHECK(journal.path().empty());
    CHECK(names_in(folder.file("state")).empty());
    REQUIRE(journal.write(work_of(2)));
    CHECK(read_journal(bytes_of(journal.path())).work == work_of(2));
}

TEST_CASE("a journal cut at any byte yields the last state that was whole by then") {
    std::string bytes = journal_head();
    std::vector<std::size_t> ends;
    for (int n = 0; n < 4; ++n) {
        bytes += journal_record(work_of(n));
        ends.push_back(bytes.size());
    }
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
        const auto whole = std::count_if(ends.begin(), ends.end(), [&](std::size_t end) { return end <= cut; });
        const JournalContent content = read_journal(std::string_view(bytes).substr(0, cut));
        INFO("cut at " << cut << " of " << bytes.size());
        if (whole > 0) REQUIRE(content.work == work_of(static_cast<int>(whole) - 1));
        REQUIRE((content.state == JournalContent::State::whole) == (whole > 0));
    }
}

TEST_CASE("a record written behind one that was cut short counts") {
    const std::string first = journal_head() + journal_record(work_of(0)), second = journal_record(work_of(1));
    for (std::size_t cut = 0; cut < second.size(); ++cut) {
        INFO("cut at " << cut << " of " << second.size());
        const JournalContent content = read_journal(first + second.substr(0, cut) + journal_record(work_of(2)));
        REQUIRE(content.work == work_of(2));
    }
}

TEST_CASE("a flipped bit never yields a state that was not written") {
    const std::string bytes = journal_head() + journal_record(work_of(0)) + journal_record(work_of(1));
    const std::size_t last_begins = bytes.size() - journal_record(work_of(1)).size();
    for (std::size_t at = 0; at < bytes.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            const JournalContent content = read_journal(damaged);
            INFO("bit " << bit << " of byte " << at);
            if (content.state == JournalContent::State::whole) {
                const bool last = at < last_begins;
                REQUIRE(content.work == work_of(last ? 1 : 0));
            } else REQUIRE(at < journal_head().size());  // taken for a later version: left alone
        }
}

TEST_CASE("a damaged journal is reported, one of a later version is left alone, an empty one is cleared away") {
    const Folder folder;
    folder.write("a.journal", journal_head() + journal_record(work_of(1)).substr(0, 60));
    folder.write("b.journal", "no journal at all");
    folder.write("c.journal", "pinfield journal 3\n" + journal_record(work_of(1)));
    folder.write("d.journal", "");
    folder.write("e.journal.tmp", journal_head());
    folder.write("notes.txt", "mine");
    fs::create_directory(folder.file("f.journal"));
    fs::create_symlink(folder.file("notes.txt"), folder.file("g.journal"));
    const Orphans orphans = find_orphans(folder.file(""));
    CHECK(orphans.found.empty());
    REQUIRE(orphans.unreadable.size() == 2);
    CHECK_THAT(orphans.unreadable[0], Catch::EndsWith("a.journal"));
    CHECK_THAT(orphans.unreadable[1], Catch::EndsWith("b.journal"));
    CHECK(names_in(folder.file("")) ==
          std::vector<std::string>{"a.journal", "b.journal", "c.journal", "f.journal", "g.journal", "notes.txt"});
    CHECK(find_orphans(folder.file("nowhere")).found.empty());
    CHECK(find_orphans("").found.empty());
}

TEST_CASE("two editors have two journals, and the newer orphan comes first") {
    const Folder folder;
    std::optional<Journal> a(folder.file("state")), b(folder.file("state"));
    REQUIRE(a->write(work_of(1)));
    REQUIRE(b->write(work_of(2)));
    CHECK(a->path() != b->path());
    CHECK(find_orphans(folder.file("state")).found.empty());
    CHECK_FALSE(remove_orphan(a->path()));
    a.reset();
    REQUIRE(find_orphans(folder.file("state")).found.size() == 1);
    CHECK(find_orphans(folder.file("state")).found[0].work == work_of(1));
    b.reset();
    const Orphans both = find_orphans(folder.file("state"));
    REQUIRE(both.found.size() == 2);
    CHECK(both.found[0].work == work_of(2));
    CHECK(both.found[1].work == work_of(1));
}

TEST_CASE("a journal that grows is begun anew with its last record, still locked") {
    const Folder folder;
    std::size_t largest = 0;
    const std::size_t most = 10'000;
    {
        Journal journal(folder.file("state"), most);
        for (int n = 0; n < 300; ++n) {
            REQUIRE(journal.write(work_of(n)));
            const std::string bytes = bytes_of(journal.path());
            largest = std::max(largest, bytes.size());
            REQUIRE(read_journal(bytes).work == work_of(n));
            if (n % 50 == 0) CHECK(find_orphans(folder.file("state")).found.empty());
        }
        CHECK(names_in(folder.file("state")).size() == 1);
    }
    CHECK(largest <= most);
    CHECK(largest > most / 2);
    CHECK(find_orphans(folder.file("state")).found[0].work == work_of(299));
}

TEST_CASE("a journal whose file was removed is begun again") {
    const Folder folder;
    Journal journal(folder.file("state"));
    REQUIRE(journal.write(work_of(1)));
    fs::remove_all(folder.file("state"));
    REQUIRE(journal.write(work_of(2)));
    CHECK(read_journal(bytes_of(journal.path())).work == work_of(2));
}

TEST_CASE("a journal that cannot be written says so, and can be tried again") {
    const Folder folder;
    folder.write("state", "a file where the folder should be");
    Journal journal(folder.file("state"));
    const Result<void> refused = journal.write(work_of(1));
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, Catch::Contains(folder.file("state")));
    CHECK_FALSE(Journal("").write(work_of(1)));
    fs::remove(folder.file("state"));
    CHECK(journal.write(work_of(1)));
}
