#include "editor/actions.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

TEST_CASE("names and shortcuts of actions are unique, and every action says what it is") {
    std::set<std::string_view> names, shortcuts;
    for (const Action& action : all_actions()) {
        INFO(action.name);
        CHECK(names.insert(action.name).second);
        if (!action.shortcut.empty()) CHECK(shortcuts.insert(action.shortcut).second);
        CHECK_FALSE(action.label.empty());
        CHECK_FALSE(action.doc.empty());
        CHECK(find_action(action.name) == &action);
        if (!action.shortcut.empty()) CHECK(action_of(action.shortcut) == &action);
    }
    CHECK_FALSE(find_action("file.burn"));
    CHECK_FALSE(action_of(""));
}

TEST_CASE("every action can be asked for and run on a fresh table") {
    for (const Action& action : all_actions()) {
        const Folder folder;
        AppState state = opened_state(folder);
        state.view.size = {800, 600};
        INFO(action.name);
        enabled(state, action.name);
        run(state, action.name);
        SUCCEED();
    }
}
