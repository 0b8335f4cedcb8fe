#include "editor/session.h"

#include <catch2/catch.hpp>

#include "editor/edit_tools.h"
#include "engine/program/compile.h"
#include "engine/program/evaluate.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// Everything that a program computes with, as numbers: equal programs give equal lists.
std::vector<double> fingerprint(const Program& program) {
    std::vector<double> out = program.fixed.params;
    const auto add_box = [&](const Box2& box) { out.insert(out.end(), {box.lo.x(), box.lo.y(), box.hi.x(), box.hi.y()}); };
    for (const Op& op : program.fixed.ops) {
        add_box(op.bounds);
        out.insert(out.end(), {op.local_from_field.offset.x(), op.local_from_field.offset.y(), op.scale, double(op.material),
                               double(op.origin.value)});
    }
    for (const Solid& solid : program.fixed.solids) add_box(solid.bounds);
    for (const Mover& mover : program.movers) {
        out.insert(out.end(), mover.field.params.begin(), mover.field.params.end());
        out.insert(out.end(), {mover.pivot.x(), mover.pivot.y(), mover.cosine, mover.sine});
    }
    for (const Part& part : program.parts) out.insert(out.end(), part.params.begin(), part.params.end());
    for (const MaterialRecord& m : program.materials) out.insert(out.end(), {m.restitution, m.falloff, m.friction});
    out.insert(out.end(), {program.physics.step, program.physics.gravity.y(), program.physics.ball_radius});
    for (int i = 0; i < 400; ++i) out.push_back(nearest(program.fixed, {0.025 * (i % 20), 0.05 * (i / 20)}).distance);
    return out;
}

constexpr const char* billiard = R"(pinfield: 1
table: {size: [0.5, 1.0], slope: 0}
materials: {default: {restitution: 1, friction: 0}}
scene:
  - bumper: {id: pop, at: [0.25, 0.5], radius: 20mm, kick: 0.5}
  - box: {id: wall, at: [0.25, 0.2], size: [100mm, 20mm]}
  - spawn: {id: start, at: [0.25, 0.7], velocity: [0, -1]}
)";

}  // namespace

TEST_CASE("what runs after any sequence of live edits is what a fresh compile gives") {
    const Folder folder;
    AppState state = opened_state(folder);
    const auto follow_and_compare = [&] {
        advance(state, 3);
        CHECK(state.session.problems().empty());
        const auto fresh = compile(state.document.scene());
        REQUIRE(fresh);
        CHECK(fingerprint(state.session.program()) == fingerprint(**fresh));
    };
    for (int i = 1; i <= 5; ++i) {
        state.document.preview(change(state.document, "pop", "at", Vec2(0.25 + 0.003 * i, 0.7)));
        follow_and_compare();
    }
    state.document.commit("Move pop");
    follow_and_compare();
    edit(state, change(state.document, "pop", "radius", 0.03), "a");
    follow_and_compare();
    edit(state, change(state.document, "corner", "turn", 45.0), "b");
    follow_and_compare();
    edit(state, change(state.document, "bat", "length", 0.06), "c");
    follow_and_compare();
    edit(state, {state.document.scene().materials()[0], 0, 0.5, true}, "d");
    follow_and_compare();
    state.document.undo();
    state.document.undo();  // two fields between two frames
    follow_and_compare();
    while (state.document.can_undo()) state.document.undo();
    follow_and_compare();
}

TEST_CASE("an edit that does not compile keeps the last good program running, and mending it goes on") {
    const Folder folder;
    AppState state = opened_state(folder);
    std::vector<std::string> too_many;
    for (int i = 0; i < 40; ++i) too_many.push_back("layer_" + std::to_string(i));
    REQUIRE_FALSE(state.document.preview(change(state.document, "bat", "layer", too_many)));
    const std::vector<double> good = fingerprint(state.session.program());
    advance(state, 5);
    REQUIRE_FALSE(state.session.problems().empty());
    CHECK(fingerprint(state.session.program()) == good);
    REQUIRE_FALSE(state.document.preview(change(state.document, "pop", "radius", 0.03)));
    advance(state, 5);
    CHECK(fingerprint(state.session.program()) == good);
    state.document.cancel_preview();
    advance(state, 5);
    CHECK(state.session.problems().empty());
    CHECK(fingerprint(state.session.program()) == fingerprint(**compile(state.document.scene())));
}

TEST_CASE("a doubt about what runs is reported and stands where the text has it, and goes when it is mended") {
    const Folder folder;
    AppState state = opened_state(folder,
                                  "pinfield: 1\nscene:\n  - round: {id: soft, radius: 5mm, children: [intersection: {children: "
                                  "[half_plane: {}, half_plane: {turn: 90}]}]}\n");
    const auto doubts = [&] { return state.session.problems(); };
    REQUIRE(doubts().size() == 1);
    CHECK(doubts()[0].code == "W0503");
    CHECK(state.document.scene().sources.line_column(doubts()[0].where) == LineColumn{3, 5});
    edit(state, change(state.document, "soft", "radius", 0.006), "a");  // a patch
    advance(state, 3);
    CHECK(doubts().size() == 1);
    edit(state, change(state.document, "soft", "radius", 0.0), "b");
    advance(state, 3);
    CHECK(doubts().empty());
}

TEST_CASE("a table that does not compile opens on an empty one and says why") {
    const Folder folder;
    AppState state = opened_state(folder, "pinfield: 1\nscene:\n  - domain: {children: []}\n");
    advance(state, 5);
    CHECK(state.session.world().tick() == 5);
    CHECK((!state.session.problems().empty() || has_errors(state.document.diagnostics())));
}

TEST_CASE("bumper hits are counted, in all and by bumper, and reset sets them to zero") {
    const Folder folder;
    AppState state = opened_state(folder, billiard);
    // From y = 0.7 down at 1 m/s: the ball's rim meets the bumper's at 0.5 + 0.020 + 0.0135, after 0.1665 s.
    advance(state, 160);
    CHECK(state.session.hits() == 0);
    advance(state, 20);
    CHECK(state.session.hits() == 1);
    CHECK(state.session.hits_of(id_of(state.document, "pop")) == 1);
    CHECK(state.session.hits_of(id_of(state.document, "wall")) == 0);
    CHECK(state.session.world().balls()[0].velocity.y() == Approx(1.5));
    run(state, "play.reset");
    CHECK(state.session.hits() == 0);
    CHECK(state.session.hits_of(id_of(state.document, "pop")) == 0);
    CHECK(state.session.world().tick() == 0);
    CHECK(state.session.world().balls()[0].position == Vec2(0.25, 0.7));
}

TEST_CASE("what is no bumper is hit without being counted") {
    const Folder folder;
    AppState state = opened_state(folder);
    advance(state, 4000);  // the ball falls on the bumper, then on the walls of the domain
    CHECK(state.session.hits() >= 1);
    CHECK(state.session.hits() == state.session.hits_of(id_of(state.document, "pop")));
}

TEST_CASE("the table plays at the speed asked for: whole ticks, none lost in slow motion") {
    const Folder folder;
    AppState state = opened_state(folder);
    const auto ticks = [&] { return state.session.world().tick(); };
    advance(state, 16);
    CHECK(ticks() == 16);
    run(state, "play.pause");
    advance(state, 100);
    CHECK(ticks() == 16);
    run(state, "play.step");
    CHECK(ticks() == 17);
    CHECK_FALSE(state.session.playing());
    run(state, "play.toggle");
    for (int i = 0; i < 10; ++i) run(state, "play.slower");
    CHECK(state.session.slow_motion() == 64);
    for (int i = 0; i < 64; ++i) advance(state, 5);
    CHECK(ticks() == 22);
    for (int i = 0; i < 10; ++i) run(state, "play.faster");
    CHECK(state.session.slow_motion() == 1);
}

TEST_CASE("a drained ball comes back to its spawn after a second, where the spawn is by then") {
    const Folder folder;
    AppState state = opened_state(folder, "pinfield: 1\ntable: {size: [0.5, 1.0], slope: 0}\nscene:\n"
                                          "  - spawn: {id: start, at: [0.25, 0.5], velocity: [0, -1]}\n"
                                          "  - drain: {at: [0.25, 0.25], size: [0.4, 0.1]}\n");
    // The centre enters the drain at y = 0.30, after 0.2 s.
    advance(state, 210);
    CHECK(state.session.drained() == 1);
    REQUIRE(edit(state, change(state.document, "start", "at", Vec2(0.3, 0.6)), "Move start"));
    advance(state, 900);
    CHECK(state.session.world().balls()[0].state == BallState::drained);
    advance(state, 120);
    const Ball& ball = state.session.world().balls()[0];
    CHECK(ball.state != BallState::drained);
    CHECK(ball.position.x() == 0.3);
    CHECK(ball.velocity == Vec2(0, -1));
    advance(state, 1000);
    CHECK(state.session.drained() == 2);
}

TEST_CASE("keys press the inputs that the table binds to them") {
    const Folder folder;
    AppState state = opened_state(folder);
    advance(state, 50);
    const double rest = state.session.world().movers()[0].q;
    CHECK(press_key(state, "Z", true));
    CHECK_FALSE(press_key(state, "Q", true));
    advance(state, 60);
    CHECK(state.session.world().movers()[0].q > rest + 0.5);
    press_key(state, "Z", false);
    advance(state, 300);
    CHECK(state.session.world().movers()[0].q == Approx(rest).margin(1e-3));
}

TEST_CASE("the same edits at the same ticks give the same bits") {
    const auto played = [] {
        const Folder folder;
        AppState state = opened_state(folder, billiard);
        NodeDrag drag;
        drag.begin(state.document, id_of(state.document, "pop"), {0.25, 0.5});
        for (int i = 0; i < 60; ++i) {
            drag.update(state.document, {0.25 + 0.001 * i, 0.5}, square_grid(default_grid));
            advance(state, 7);
        }
        drag.end(state.document);
        advance(state, 500);
        return state.session.world().state_hash();
    };
    CHECK(played() == played());
}

TEST_CASE("a wall or bumper dragged over a rolling ball never swallows it") {
    const std::string node = GENERATE("pop", "wall");
    const Folder folder;
    AppState state = opened_state(folder, billiard);
    const double radius = state.session.program().physics.ball_radius;
    CAPTURE(node);
    for (int pass = 0; pass < 20; ++pass) {
        const Vec2 begin = state.document.scene().find(node)->get<Vec2>("at");
        NodeDrag drag;
        REQUIRE(drag.begin(state.document, id_of(state.document, node), begin));
        for (int i = 1; i <= 10; ++i) {  // the hand follows the ball, so that the node lands on it
            const Vec2 ball = state.session.world().balls()[0].position;
            REQUIRE_FALSE(drag.update(state.document, begin + 0.1 * i * (ball - begin), square_grid(default_grid)));
            advance(state, 4);
        }
        REQUIRE_FALSE(drag.end(state.document));
        advance(state, 400);  // let out at a bounded speed
        const Ball& ball = state.session.world().balls()[0];
        REQUIRE(ball.position.allFinite());
        CHECK(Box2{{0, 0}, {0.5, 1.0}}.grown(-radius + 1e-6).contains(ball.position));
        CHECK(nearest(state.session.program().fixed, ball.position).distance >= radius - 1e-6);
    }
    CHECK(changed_lines(billiard, state.document.source().text()) == 1);
}
