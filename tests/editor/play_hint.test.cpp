#include "editor/play_hint.h"

#include <catch2/catch.hpp>

#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string lane = R"(pinfield: 1
table: {size: [0.2, 1]}
scene:
  - domain: {children: [box: {size: [0.04, 0.9], at: [0.1, 0.5]}]}
  - plunger: {at: [0.1, 0.16], size: [20mm, 60mm], input: [shoot]}
  - spawn: {at: [0.1, 0.2]}
inputs: {shoot: [Space, Enter]}
)";

/// A state whose ball has had a second to come down.
AppState waiting(const Folder& folder, const std::string& table = lane) {
    AppState state = opened_state(folder, table);
    advance(state, 2000);
    return state;
}

}  // namespace

TEST_CASE("a ball that lies on the plunger waits for the plunger's key, and says so while the table plays") {
    const Folder folder;
    AppState state = waiting(folder);
    const auto hint = play_hint(state);
    REQUIRE(hint);
    CHECK(hint->text == "Hold Space to shoot");
    CHECK(hint->at == state.session.world().balls()[0].position);
    state.session.play(false);
    CHECK_FALSE(play_hint(state));
}

TEST_CASE("a ball in flight, or on what has no key, waits for nothing") {
    const Folder folder;
    AppState flying = opened_state(folder, lane);
    advance(flying, 100);
    CHECK_FALSE(play_hint(flying));
    std::string keyless = lane;
    keyless.replace(keyless.find(", input: [shoot]"), 16, "");
    AppState idle = waiting(folder, keyless);
    CHECK_FALSE(play_hint(idle));
}
