// The tables that File > New offers, the palette, and what both are drawn with.
#include "editor/starters.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "editor/picture.h"
#include "editor/session.h"
#include "engine/core/at.h"
#include "engine/program/compile.h"
#include "engine/program/evaluate.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

TEST_CASE("every table to begin with reads and compiles without a word, and plays for half a minute") {
    for (const Starter& starter : starters()) {
        INFO(action_of(starter));
        AppState state = untitled_state();
        run(state, action_of(starter));
        CHECK(state.document.source().text() == starter.text);
        CHECK_FALSE(state.document.dirty());
        CHECK(state.document.diagnostics().empty());
        CHECK(state.session.problems().empty());
        for (int tick = 0; tick < 30'000; tick += 10) {
            if (tick % 2000 == 0) press_key(state, "Space", tick % 4000 == 0);
            if (tick % 700 == 0) press_key(state, "Z", tick % 1400 == 0);
            advance(state, 10);
        }
        for (const Ball& ball : state.session.world().balls())
            if (ball.state != BallState::drained) CHECK(nearest(state.session.program().fixed, ball.position).distance > 0);
        if (starter.key == "classic" || starter.key == "fan") CHECK(state.session.hits() > 0);
    }
}

TEST_CASE("a new table asks which, and about unsaved work once it is chosen") {
    const Folder folder;
    AppState state = opened_state(folder);
    edit(state, change(state.document, "pop", "radius", 0.03), "Change");
    run(state, "file.new");
    CHECK(state.choosing);
    CHECK_FALSE(enabled(state, "edit.undo"));
    run(state, "new.cancel");
    CHECK_FALSE(state.choosing);
    run(state, "file.new");
    run(state, "new.fan");
    REQUIRE(state.prompt);
    run(state, "prompt.cancel");
    CHECK(state.choosing);
    run(state, "new.fan");
    run(state, "prompt.discard");
    CHECK_FALSE(state.choosing);
    CHECK(state.document.source().text() == starters()[1].text);
}

TEST_CASE("pictures lie on the outlines of what they show") {
    int drawn = 0;
    for (const NodeType& type : catalog()->types()) {
        if (type.meta.kind == NodeKind::record || type.key() == "domain") continue;
        INFO(type.key());
        const Picture picture = picture_of(catalog(), type);
        drawn += !picture.lines.empty();
        if (type.meta.kind != NodeKind::shape) continue;
        Scene scene(catalog());
        scene.put(scene.with_new_ids(new_nodes(catalog(), type)), {}, 0);
        const ProgramPtr program = *compile(scene);
        const double within = program->fixed.solids[0].piece_count > 0 ? 2e-5 : 1e-3;  // fitted pieces; a grid of 12 mm
        double length_drawn = 0;
        for (const auto& line : picture.lines)
            for (std::size_t i = 0; i < line.size(); ++i) {
                if (i > 0) length_drawn += length(line[i] - line[i - 1]);
                CHECK(std::fabs(nearest_of_solid(program->fixed, 0, line[i]).distance) < within);
            }
        CHECK(length_drawn > 0.01);
    }
    CHECK(drawn >= 78);                                                  // all but groups and what fills the picture
    CHECK(picture_of(Scene(catalog())).box.size() == Vec2(0.52, 1.06));  // the edge of a table without a domain
}
