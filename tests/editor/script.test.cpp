#include "editor/script.h"

#include <catch2/catch.hpp>

#include <deque>
#include <functional>

#include "editor/edit_tools.h"
#include "editor/pick.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

/// A window that does with the mouse and the keys what the real one does, and writes down what it was asked.
class FakeWindow : public ScriptHost {
public:
    explicit FakeWindow(AppState& state) : state_(state) {}

    void move_mouse(const Vec2& pixel) override { events_.push_back([this, pixel] { mouse_ = state_.view.world_from_pixel(pixel); }); }
    void press_mouse(int, bool down) override {
        events_.push_back([this, down] {
            if (down) state_.selection.set(pick(state_, mouse_, 0.002));
            if (down && !state_.selection.empty()) drag_.begin(state_.document, state_.selection.primary(), mouse_);
            if (!down) drag_.end(state_.document);
        });
    }
    void scroll(double) override {}
    void type(unsigned) override {}
    std::optional<Vec2> find_words(std::string_view, std::string_view) const override { return {}; }
    bool press_key(std::string_view key, bool down) override {
        events_.push_back([this, name = std::string(key), down] { editor::press_key(state_, name, down); });
        return key != "Nonsense";
    }
    Result<bool> screenshot(const std::string& path) override {
        if (path.empty()) return failure("no path");
        screenshots.push_back(path);
        return true;
    }
    int ticks_per_frame() const override { return 16; }

    void frame(int ticks) {
        for (const auto& event : events_) event();
        events_.clear();
        if (drag_.active()) drag_.update(state_.document, mouse_, square_grid(default_grid));
        advance(state_, ticks);
        most_ticks = std::max(most_ticks, ticks);
    }

    std::vector<std::string> screenshots;
    int most_ticks = 0;

private:
    AppState& state_;
    std::deque<std::function<void()>> events_;
    Vec2 mouse_{0, 0};
    NodeDrag drag_;
};

/// Runs a script to its end and returns its failure.
std::string play(AppState& state, FakeWindow& window, const std::string& text) {
    state.view.size = {800, 900};
    run(state, "view.all");
    const SourceText source("steps.yaml", text);
    Script script = read_script(source);
    REQUIRE(script.diagnostics.empty());
    ScriptRunner runner(source, std::move(script));
    int frames = 0;
    while (!runner.done()) {
        REQUIRE(++frames < 10'000);
        const int ticks = runner.before_frame(state, window);
        if (!runner.done()) window.frame(ticks);
    }
    return runner.failure();
}

}  // namespace

TEST_CASE("a script drags, sets, undoes, saves and expects") {
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    const std::string failure = play(state, window, R"(
- {drag: {from: [0.25, 0.70], to: [0.30, 0.65]}}
- {expect: {node: pop, field: at, value: [0.30, 650mm], tolerance: 1mm}}
- {expect: {node: editor, field: dirty, value: true}}
- {expect: {node: editor, field: undo_steps, value: 1}}
- {expect: {node: editor, field: selection, value: pop}}
- {set: {node: pop, field: radius, value: 30mm}}
- {expect: {node: pop, field: radius, value: 3cm}}
- {action: edit.undo}
- {expect: {node: pop, field: radius, value: 24mm}}
- {select: shelf}
- {expect: {node: editor, field: selection, value: shelf}}
- {action: file.save}
- {expect: {node: editor, field: dirty, value: false}}
- {screenshot: out.png}
)");
    CHECK(failure.empty());
    CHECK(window.screenshots == std::vector<std::string>{"out.png"});
    CHECK(changed_lines(pen, folder.read("table.yaml")) == 1);
}

TEST_CASE("a script sets the fields of physics, of the table and of materials by their paths") {
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    const std::string material = state.document.scene().materials().empty()
                                     ? ""
                                     : state.document.scene().path(state.document.scene().materials()[0]);
    REQUIRE(material.starts_with("materials/"));
    CHECK(
        play(
            state, window,
            "- {set: {node: physics, field: step, value: 2ms}}\n- {expect: {node: physics, field: step, value: 2ms}}\n")
            .empty());
    CHECK(
        play(state, window,
             "- {set: {node: table, field: name, value: Dawn}}\n- {expect: {node: table, field: name, value: Dawn}}\n")
            .empty());
    CHECK(play(state, window,
               "- {set: {node: " + material + ", field: restitution, value: 0.1}}\n- {expect: {node: " + material +
                   ", field: restitution, value: 0.1}}\n")
              .empty());
}

TEST_CASE("waits and keys take exactly their ticks, in frames of a fixed number") {
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    CHECK(play(state, window, "- {wait: {ticks: 50}}\n").empty());
    CHECK(state.session.world().tick() == 50);
    CHECK(window.most_ticks == 16);
    const double rest = state.session.world().movers()[0].q;
    CHECK(play(state, window, "- {key: {press: Z, ticks: 40}}\n").empty());
    CHECK(state.session.world().tick() == 90);
    CHECK(state.session.world().movers()[0].q > rest + 0.3);
    CHECK(play(state, window, "- {wait: {ticks: 400}}\n").empty());
    CHECK(state.session.world().movers()[0].q == Approx(rest).margin(1e-3));
}

TEST_CASE("a script counts hits and balls") {
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    CHECK(play(state, window, "- {wait: {ticks: 3000}}\n"
                              "- {expect: {node: pop, field: hits, value: '>= 1'}}\n"
                              "- {expect: {node: editor, field: hits, value: '!= 0'}}\n"
                              "- {expect: {node: editor, field: balls, value: 1}}\n"
                              "- {action: play.reset}\n"
                              "- {expect: {node: pop, field: hits, value: 0}}\n")
              .empty());
}

TEST_CASE("a step that fails says its number, its line and why, and nothing runs after it") {
    struct Case {
        const char* step;
        const char* why;
    };
    const auto [step, why] = GENERATE(
        Case{"{expect: {node: pop, field: radius, value: 25mm}}", "pop.radius is 24mm, not 25mm"},
        Case{"{expect: {node: pop, field: radius, value: 25mm, tolerance: 0.9mm}}", "pop.radius is 24mm, not 25mm"},
        Case{"{expect: {node: pop, field: radius, value: soon}}", "soon"},
        Case{"{expect: {node: pip, field: radius, value: 1}}", "no node pip"},
        Case{"{expect: {node: pop, field: width, value: 1}}", "no field width"},
        Case{"{expect: {node: editor, field: hits, value: '> 100'}}", "editor.hits is 0, not > 100"},
        Case{"{set: {node: pop, field: radius, value: -1}}", "above 0"}, Case{"{set: {node: pop, field: radius, value: 3deg}}", "3deg"},
        Case{"{action: edit.redo}", "cannot be done now"}, Case{"{action: file.burn}", "no action file.burn"},
        Case{"{select: nobody}", "no node nobody"}, Case{"{key: {press: Nonsense, ticks: 10}}", "no key Nonsense"},
        Case{"{drag: {from: [0.25, 0.70], to: [9, 9]}}", "[9, 9] is not in the viewport"});
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    const std::string failure = play(state, window, std::string("- {select: shelf}\n# two\n- ") + step + "\n- {select: pop}\n");
    INFO(failure);
    CHECK_THAT(failure, Catch::StartsWith("steps.yaml:3:"));
    CHECK_THAT(failure, Catch::Contains("step 2 ("));
    CHECK_THAT(failure, Catch::Contains(why));
    CHECK(state.selection.primary() == id_of(state.document, "shelf"));
}

TEST_CASE("an action that fails fails its step") {
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    CHECK(play(state, window, "- {set: {node: pop, field: kick, value: 1}}\n").empty());
    std::string theirs = pen;
    folder.write("table.yaml", theirs.replace(theirs.find("kick: 0.8"), 9, "kick: 0.7"));
    CHECK_THAT(play(state, window, "- {action: file.save}\n"), Catch::Contains("changed on disk too"));
}

TEST_CASE("the same script gives the same bits") {
    const auto hash = [] {
        const Folder folder;
        AppState state = opened_state(folder);
        FakeWindow window(state);
        CHECK(play(state, window,
                   "- {drag: {from: [0.25, 0.70], to: [0.24, 0.65]}}\n- {key: {press: Z, ticks: 100}}\n- {wait: {ticks: 500}}\n")
                  .empty());
        return state.session.world().state_hash();
    };
    CHECK(hash() == hash());
}

TEST_CASE("a script inserts, wraps, moves, renames, unwraps, removes and pastes, and stops where that cannot be") {
    const Folder folder;
    AppState state = opened_state(folder);
    FakeWindow window(state);
    CHECK(play(state, window,
               "- {insert: {yaml: 'star: {id: s}', parent: corner, index: 0}}\n"
               "- {insert: {yaml: 'circle: {id: c, at: [0.2, 0.2], radius: 10mm}'}}\n"
               "- {wrap: {nodes: [shelf, c], in: union}}\n"
               "- {rename: {node: s, id: star}}\n"
               "- {move: {node: star, index: 0}}\n"
               "- {select: [pop, bat]}\n"
               "- {unwrap: corner}\n"
               "- {remove: [nail, post]}\n"
               "- {paste: 'circle: {id: p, radius: 5mm}'}\n") == "");
    const Scene& scene = state.document.scene();
    CHECK(scene.find(scene.roots().front())->name == "star");
    CHECK(scene.find(scene.find("shelf")->parent)->type->key() == "union");
    CHECK(scene.find("c")->parent == scene.find("shelf")->parent);
    CHECK_FALSE(scene.find("corner"));
    CHECK_FALSE(scene.find("nail"));
    CHECK(scene.find("p"));
    CHECK(play(state, window, "- {remove: nobody}\n").ends_with("there is no node nobody"));
    CHECK(play(state, window, "- {insert: {yaml: 'circle: {radius: -1}'}}\n").starts_with("steps.yaml:1:4: step 1 (insert): "));
    CHECK(play(state, window, "- {wrap: {nodes: pop, in: unon}}\n").ends_with("no node is called unon"));
}
