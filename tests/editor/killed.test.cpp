// Processes that are killed while they edit, at random moments.
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <random>
#include <thread>

#include "editor/keep_work.h"
#include "engine/core/numbers.h"
#include "engine/io/files.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

namespace fs = std::filesystem;

std::size_t files_in(const std::string& folder) {
    std::error_code none;
    std::size_t count = 0;
    for (fs::directory_iterator it(folder, none), end; !none && it != end; ++it) ++count;
    return count;
}

/// Does the work, which takes a function to report with and never ends by itself, in a process of its own, and kills that so long after its
/// first report and `more` others: a busy machine only takes longer over them. Returns the last one.
template <class Report, class Work>
Report last_report_of_killed(Work work, std::int64_t microseconds, unsigned more = 0) {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        work([&](const Report& report) {
            if (::write(ends[1], &report, sizeof report) != sizeof report) ::_exit(1);
        });
        ::_exit(1);
    }
    ::close(ends[1]);
    Report last{};
    for (unsigned i = 0; i <= more; ++i) CHECK(::read(ends[0], &last, sizeof last) == sizeof last);
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    while (::read(ends[0], &last, sizeof last) == sizeof last) {}
    ::close(ends[0]);
    return last;
}

/// How often a test kills: PINFIELD_KILLS asks for another number.
int kills(int usually) {
    const char* const text = std::getenv("PINFIELD_KILLS");
    return text ? static_cast<int>(parse_number(text).value_or(usually)) : usually;
}

/// The n-th state of some table: its text grows and shrinks.
UnsavedWork work_of(int n) {
    std::string text = "pinfield: 1\nscene:\n";
    for (int i = 0; i <= n % 7; ++i) text += "  - circle: {radius: " + std::to_string(n) + "mm}\n";
    return {"/tables/pen.yaml", "pinfield: 1\n", text, n, "Edit " + std::to_string(n), 1'000'000 + n};
}

/// What a process that writes a journal has to say, before and after it writes.
struct Report {
    enum Kind : int { begins, done, dropping, dropped };
    int kind = begins;
    int state = 0;
};

/// Writes state after state, drops the journal now and then. Small files, so that they are often begun anew.
template <class Tell>
void write_journals(const std::string& folder, Tell tell) {
    Journal journal(folder, 4'000);
    for (int n = 1;; ++n) {
        tell({Report::begins, n});
        if (!journal.write(work_of(n))) return;
        tell({Report::done, n});
        if (n % 32 != 0) continue;
        tell({Report::dropping, n});
        journal.drop();
        tell({Report::dropped, n});
    }
}

/// The n-th text of a table that is saved again and again, of some kilobytes.
std::string saved_text(int n) { return std::string(static_cast<std::size_t>(2'000 + 500 * (n % 9)), static_cast<char>('a' + n % 26)) + std::to_string(n); }

/// Tells 2n when save n begins, 2n + 1 when it is done.
template <class Tell>
void save_and_save(const std::string& table, Tell tell) {
    for (int n = 1;; ++n) {
        tell(2 * n);
        if (!save_file(table, saved_text(n), saved_text(n - 1))) return;
        tell(2 * n + 1);
    }
}

AppState keeping_state(const Folder& folder) {
    AppState state(catalog(), *Document::open(folder.file("table.yaml"), catalog()));
    keep_work(state, folder.file("journals"));
    return state;
}

double kick_of(int n) { return n / 64.0; }

/// How a number is spelled follows from the one before it, so all steps are made.
std::string text_of_step(int n) {
    const Folder folder;
    Document document = opened(folder);
    for (int i = 1; i <= n; ++i) REQUIRE_FALSE(document.edit(change(document, "pop", "kick", kick_of(i)), "Kick"));
    return document.source().text();
}

/// Edits, undoes and redoes every fifth step, saves every seventh. Tells 2n when step n begins, 2n + 1 when it is done.
template <class Tell>
void edit_and_save(const Folder& folder, Tell tell) {
    AppState state = keeping_state(folder);
    for (int n = 1; n < 6'000; ++n) {
        tell(2 * n);
        if (!edit(state, change(state.document, "pop", "kick", kick_of(n)), "Kick")) return;
        if (n % 5 == 0) run(state, "edit.undo");
        if (n % 5 == 0) run(state, "edit.redo");
        if (n % 7 == 0) run(state, "file.save");
        advance(state, 0);
        tell(2 * n + 1);
    }
}

}  // namespace

namespace {

/// Types a line that does not read, letter by letter, after an edit: n letters, told when they are kept.
constexpr std::string_view typed_line = "- circle: {radius: [what a person types on the way to something that reads";

template <class Tell>
void type_and_type(const Folder& folder, Tell tell) {
    AppState state = keeping_state(folder);
    if (!edit(state, change(state.document, "pop", "kick", kick_of(3)), "Kick")) return;
    const std::size_t begin = state.document.source().text().find("  - flipper:");
    for (int n = 1;; n = n % static_cast<int>(typed_line.size()) + 1) {
        if (n == 1) {
            state.source.discard();
            tell(0);
        }
        const std::size_t at = begin + static_cast<std::size_t>(n - 1);
        const std::string letter(1, typed_line[static_cast<std::size_t>(n - 1)]);
        state.source.type(state.document, {{at, at}, n == 1 ? letter + "\n" : letter});
        state.source.pass(state.document, n % 9 == 0 ? 1 : 0);
        advance(state, 0);
        tell(n);
    }
}

}  // namespace

TEST_CASE("an editor that is killed while somebody types gives back every letter that does not read yet, over the edits that do") {
    const Folder folder;
    std::mt19937 random(13);
    int with_draft = 0;
    for (int kill = 0; kill < kills(30); ++kill) {
        folder.write("table.yaml", pen);
        const int last = last_report_of_killed<int>([&](auto report) { type_and_type(folder, report); }, random() % 20'000, static_cast<unsigned>(random() % 200));
        INFO("kill " << kill << " after letter " << last);
        AppState state = keeping_state(folder);
        REQUIRE(state.recovery);
        run(state, "recover.restore");
        CHECK(state.document.scene().find("pop")->get<double>("kick") == kick_of(3));
        CHECK(state.document.undo_steps() == 1);
        std::string typed = state.source.text(state.document)->text();
        const std::size_t begin = state.document.source().text().find("  - flipper:");
        const auto count = typed.size() - state.document.source().text().size();
        const std::size_t letters = count == 0 ? 0 : count - 1;
        CHECK(typed.substr(begin, letters) == typed_line.substr(0, letters));
        const auto due = static_cast<std::size_t>(last);
        CHECK((letters == due || letters == due % typed_line.size() + 1 || (due <= 1 && (letters == 0 || letters == typed_line.size()))));
        with_draft += state.source.pending();
        CHECK(state.source.pending() == (letters > 0));
        run(state, "source.discard");
        run(state, "file.save");
        advance(state, 0);
        REQUIRE(files_in(folder.file("journals")) == 0);
    }
    CHECK(with_draft > kills(30) / 2);
}

TEST_CASE("an editing process may be killed at any moment: what it had written is found, and nothing else is left") {
    const Folder folder;
    const std::string place = folder.file("state");
    std::mt19937 random(7);
    int with_work = 0, mid_write = 0, mid_drop = 0;
    for (int i = 0; i < kills(200); ++i) {
        const auto more = static_cast<unsigned>(random() % 200);
        const Report last = last_report_of_killed<Report>([&](auto report) { write_journals(place, report); }, random() % 1'000, more);
        const Orphans orphans = find_orphans(place);
        INFO("kill " << i << ", last report " << last.kind << " of state " << last.state);
        REQUIRE(orphans.unreadable.empty());
        REQUIRE(orphans.found.size() <= 1);
        const int found = orphans.found.empty() ? 0 : static_cast<int>(orphans.found[0].work.edits);
        if (found > 0) REQUIRE(orphans.found[0].work == work_of(found));
        const int before = last.state % 32 == 1 ? 0 : last.state - 1;  // the journal began with each 32nd state
        switch (last.kind) {
            case Report::begins: REQUIRE((found == before || found == last.state)); break;
            case Report::done: REQUIRE(found == last.state); break;
            case Report::dropping: REQUIRE((found == 0 || found == last.state)); break;
            case Report::dropped: REQUIRE(found == 0); break;
        }
        with_work += found > 0;
        mid_write += last.kind == Report::begins;
        mid_drop += last.kind == Report::dropping;
        if (found > 0) REQUIRE(remove_orphan(orphans.found[0].file));
        REQUIRE(files_in(place) == 0);
    }
    if (kills(200) > 200) WARN(with_work << " left work, " << mid_write << " died during a write, " << mid_drop << " during a drop");
    CHECK(with_work > kills(200) / 2);
}

TEST_CASE("a saving process may be killed at any moment: the file is whole, a save that was done is there, and the next one clears up") {
    const Folder folder;
    const std::string table = folder.file("table.yaml");
    std::mt19937 random(5);
    int amid = 0, strays = 0;
    for (int kill = 0; kill < kills(300); ++kill) {
        folder.write("table.yaml", saved_text(0));
        const auto more = static_cast<unsigned>(random() % 20);
        const int last = last_report_of_killed<int>([&](auto report) { save_and_save(table, report); }, random() % 1'000, more);
        const bool done = last % 2 == 1;
        const int n = last / 2;
        INFO("kill " << kill << " at save " << n << (done ? ", done" : ", begun"));
        const std::string now = folder.read("table.yaml");
        REQUIRE((now == saved_text(n) || (!done && now == saved_text(n - 1))));
        amid += !done;
        strays += files_in(fs::path(table).parent_path().string()) > 2;
        REQUIRE(save_file(table, "after", now));
        REQUIRE(files_in(fs::path(table).parent_path().string()) == 2);
    }
    if (kills(300) > 300) WARN(amid << " died during a save, " << strays << " left a temporary file, which the next save took away");
    CHECK(amid > kills(300) / 4);
}

TEST_CASE("an editor that is killed at any moment loses no step that was done: restored, or saved, byte for byte") {
    const Folder folder;
    std::mt19937 random(11);
    int restored = 0, amid = 0;
    for (int kill = 0; kill < kills(30); ++kill) {
        folder.write("table.yaml", pen);
        const int last = last_report_of_killed<int>([&](auto report) { edit_and_save(folder, report); }, random() % 60'000);
        const bool done = last % 2 == 1;
        const int n = last / 2;
        INFO("kill " << kill << " at step " << n << (done ? ", done" : ", begun"));
        AppState state = keeping_state(folder);
        CHECK_FALSE(state.message_is_problem);
        if (state.recovery) run(state, "recover.restore"), ++restored;
        amid += !done;
        const std::string& text = state.document.source().text();
        REQUIRE((text == text_of_step(n) || (!done && text == text_of_step(n - 1))));
        if (state.document.dirty()) run(state, "file.save");
        CHECK(folder.read("table.yaml") == text);
        advance(state, 0);
        REQUIRE(files_in(folder.file("journals")) == 0);
    }
    CHECK(restored > kills(30) / 6);
    CHECK(amid > kills(30) / 10);
}
