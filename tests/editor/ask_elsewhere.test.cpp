// The desktop's file dialog: a program of the test's own stands for it.
#include "editor/ask_elsewhere.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

#include "editor/platform/native_dialog.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

namespace fs = std::filesystem;

/// A desktop whose zenity is this shell script; the old environment comes back with the end of the test.
class Desktop {
public:
    explicit Desktop(const std::string& script) : path_(value("PATH")), display_(value("DISPLAY")) {
        folder_.write("zenity", "#!/bin/sh\n" + script);
        fs::permissions(folder_.file("zenity"), fs::perms::owner_all);
        ::setenv("PATH", (folder_.file("") + ":" + path_).c_str(), 1);
        ::setenv("DISPLAY", ":0", 1);
    }
    ~Desktop() {
        ::setenv("PATH", path_.c_str(), 1);
        display_.empty() ? ::unsetenv("DISPLAY") : ::setenv("DISPLAY", display_.c_str(), 1);
    }
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;
    const Folder& folder() const { return folder_; }

private:
    static std::string value(const char* name) { return std::getenv(name) ? std::getenv(name) : ""; }

    Folder folder_;
    std::string path_, display_;
};

NativeDialog::State answer_of(NativeDialog& dialog) {
    NativeDialog::State state = NativeDialog::State::waiting;
    for (int i = 0; i < 2'000 && state == NativeDialog::State::waiting; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        state = dialog.poll();
    }
    return state;
}

/// Answers what it is told to, and notes what it is asked.
struct Told {
    bool there = true;
    PathAnswer answer{};
    int opened = 0, closed = 0;
    bool saves = false;
    std::string at{}, asked{};

    void frame(AppState& state) {
        const PathAsker asker{
            [&](const PathQuestion& question, const std::string& place) { return ++opened, saves = question.saves, at = place, there; },
            [&] { return std::exchange(answer, {}); }, [&] { ++closed; }};
        ask_elsewhere(state, asker, asked);
    }
};

}  // namespace

TEST_CASE("the desktop's dialog is found on the path, asked for tables, and gives the path that was chosen") {
    const Desktop desktop("printf '%s\\n' \"$@\" > \"$(dirname \"$0\")/asked\"\nprintf '/tables/my pen.yaml\\n'\n");
    CHECK(program_called("zenity") == desktop.folder().file("") + "/zenity");
    CHECK(program_called("no-such-program").empty());
    NativeDialog dialog;
    CHECK(dialog.poll() == NativeDialog::State::none);
    REQUIRE(dialog.open({"Save the table as", "Tables", "*.yaml *.yml", true}, "/tables/pen.yaml"));
    REQUIRE(answer_of(dialog) == NativeDialog::State::chosen);
    CHECK(dialog.path() == "/tables/my pen.yaml");
    CHECK(dialog.poll() == NativeDialog::State::none);
    const std::string asked = desktop.folder().read("asked");
    for (const char* word : {"--file-selection\n", "--save\n", "--filename=/tables/pen.yaml\n", "--title=Save the table as\n",
                             "--file-filter=Tables | *.yaml *.yml\n"})
        CHECK_THAT(asked, Catch::Contains(word));
}

TEST_CASE("a cancelled dialog, one that fails and one that is closed give no path; nobody waits for it") {
    {
        const Desktop desktop("exit 1\n");
        NativeDialog dialog;
        REQUIRE(dialog.open({"Open a table", "Tables", "*.yaml"}, ""));
        CHECK(answer_of(dialog) == NativeDialog::State::cancelled);
    }
    {
        const Desktop desktop("exit 255\n");
        NativeDialog dialog;
        REQUIRE(dialog.open({"Open a table", "Tables", "*.yaml"}, ""));
        CHECK(answer_of(dialog) == NativeDialog::State::failed);
    }
    {
        const Desktop desktop("exec sleep 1000\n");
        NativeDialog dialog;
        REQUIRE(dialog.open({"Open a table", "Tables", "*.yaml"}, ""));
        CHECK(dialog.poll() == NativeDialog::State::waiting);
        dialog.close();
        CHECK(dialog.poll() == NativeDialog::State::none);
    }
}

TEST_CASE("a chosen path opens, or is saved to without a second question") {
    const Folder folder;
    AppState state = opened_state(folder);
    folder.write("other.yaml", pen);
    Told told;
    told.frame(state);
    CHECK(told.opened == 0);
    run(state, "file.open");
    told.frame(state);
    told.frame(state);
    CHECK(told.opened == 1);
    CHECK(told.at == folder.file("table.yaml"));
    CHECK(state.asks_elsewhere);
    CHECK(asks(state));
    told.answer = {PathAnswer::Kind::chosen, folder.file("other.yaml")};
    told.frame(state);
    CHECK_FALSE(state.asks_elsewhere);
    CHECK(state.document.path() == folder.file("other.yaml"));
    run(state, "file.save_as");
    told.frame(state);
    CHECK(told.saves);
    told.answer = {PathAnswer::Kind::chosen, folder.file("table.yaml")};
    told.frame(state);
    CHECK(state.document.path() == folder.file("table.yaml"));
    CHECK(state.dialog_action.empty());
}

TEST_CASE("cancelled there is cancelled here, cancelled here closes it there, and the window asks where there is none") {
    const Folder folder;
    AppState state = opened_state(folder);
    Told told;
    run(state, "file.open");
    told.frame(state);
    told.answer.kind = PathAnswer::Kind::cancelled;
    told.frame(state);
    CHECK(state.dialog_action.empty());
    run(state, "file.open");
    told.frame(state);
    CHECK(told.opened == 2);
    run(state, "dialog.cancel");
    told.frame(state);
    CHECK(told.closed == 1);
    CHECK_FALSE(state.asks_elsewhere);
    run(state, "file.open");
    told.frame(state);
    told.answer.kind = PathAnswer::Kind::failed;
    told.frame(state);
    told.frame(state);
    CHECK_FALSE(state.asks_elsewhere);
    CHECK(state.dialog_action == "file.open");
    CHECK(told.opened == 3);
    run(state, "dialog.cancel");
    told.there = false;
    told.frame(state);
    run(state, "file.open");
    told.frame(state);
    CHECK_FALSE(state.asks_elsewhere);
    CHECK(state.dialog_action == "file.open");
}

TEST_CASE("a path that cannot be opened is asked for again by the window, with the reason") {
    const Folder folder;
    AppState state = opened_state(folder);
    Told told;
    run(state, "file.open");
    told.frame(state);
    told.answer = {PathAnswer::Kind::chosen, folder.file("nowhere.yaml")};
    told.frame(state);
    told.frame(state);
    CHECK(state.dialog_action == "file.open");
    CHECK_FALSE(state.asks_elsewhere);
    CHECK(state.message_is_problem);
    CHECK(told.opened == 1);
}
