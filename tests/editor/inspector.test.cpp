// The inspector as a person sees and uses it, in a frame without a window.
#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>

#include "tests/conformance/spectacles.h"
#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const ImVec2 panel_size{340, 900};  // room for every row of any node

/// An inspector alone on a screen of its own size.
class Inspector : public Screen {
public:
    Inspector(std::shared_ptr<const Catalog> known, const std::string& table)
        : Screen(panel_size), state_(known, *Document::open(folder_.write("table.yaml", table), known)) {}

    AppState& state() { return state_; }
    void select(std::string_view id) { state_.selection.set(id_of(state_.document, id)); }

    const std::vector<ScreenText>& frame() {
        frame_of([&] {
            inspector_panel(state_, ui_, {0, 0}, panel_size);
        });
        return seen_;
    }
    const ScreenText* find(std::string_view text) const {
        const auto found = std::find_if(seen_.begin(), seen_.end(), [&](const ScreenText& t) { return t.text == text; });
        return found == seen_.end() ? nullptr : &*found;
    }
    void drag(const ImVec2& from, float pixels) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = from;
        frame();
        io.MouseDown[0] = true;
        frame();
        for (const float share : {0.3f, 0.7f, 1.0f}) {
            io.MousePos = {from.x + share * pixels, from.y};
            frame();
        }
        io.MouseDown[0] = false;
        frame();
    }
    void click(const ImVec2& place) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = place;
        frame();
        for (const bool down : {true, false}) {
            io.MouseDown[0] = down;
            frame();
        }
        frame();
    }
    std::string all() const {
        std::string out;
        for (const ScreenText& t : seen_) out += "[" + t.text + "]";
        return out;
    }

private:
    Folder folder_;
    AppState state_;
};

}  // namespace

TEST_CASE("a shape that a program adds of its own has its fields in the inspector, where they can be dragged") {
    Inspector inspector(pinfield::test::catalog_with_spectacles(), pinfield::test::spectacles_table);
    inspector.select("nose");
    inspector.frame();
    INFO(inspector.all());
    for (const char* text : {"nose", "spectacles", "Two discs side by side.", "radius", "gap", "18", "14", "line 4"}) {
        INFO(text);
        CHECK(inspector.find(text));
    }

    const ScreenText* gap = inspector.find("14");
    REQUIRE(gap);
    inspector.drag({gap->at.x + 4, gap->at.y + 6}, 40);
    const Node& nose = *inspector.state().document.scene().find("nose");
    CHECK(nose.get<double>("gap") > 0.014);
    CHECK(nose.get<double>("radius") == 0.018);
    const std::string text = inspector.state().document.source().text();
    CHECK(changed_lines(text, pinfield::test::spectacles_table) == 1);
    CHECK(text.ends_with("}  # kept\n"));
}

TEST_CASE("badges tell per side whether a node's distance is exact or a bound, how fast it changes, and whether its boundary is known") {
    Inspector inspector(catalog(), R"(pinfield: 1
scene:
  - union: {id: both, children: [circle: {id: disc, radius: 20mm}, box: {at: [0.02, 0]}]}
  - intersection: {id: wedge, children: [half_plane: {}, half_plane: {turn: 90}]}
  - smooth_union: {id: goo, children: [half_plane: {}, ellipse: {}]}
  - smooth_union: {id: drop, children: [circle: {}, ellipse: {}]}
  - spawn: {id: start}
)");
    struct Case {
        const char* node;
        std::vector<const char*> shown, absent;
    };
    const std::vector<Case> cases = {
        {"both", {"exact on both sides", "boundary known", "L = 1"}, {"bound inside"}},
        {"disc", {"exact on both sides", "L = 1"}, {"boundary known", "bound on both sides"}},
        {"wedge", {"bound outside", "exact inside", "L = 1"}, {"boundary known", "exact outside"}},
        {"goo", {"bound on both sides", "L = 1"}, {"boundary known", "exact outside"}},
        {"drop", {"right to 11 nm", "boundary fitted", "L = 1"}, {"boundary known", "exact on both sides", "bound on both sides"}},
        {"start", {"start"}, {"exact on both sides", "bound on both sides", "L = 1"}},
    };
    for (const Case& c : cases) {
        inspector.select(c.node);
        inspector.frame();
        INFO(c.node << ": " << inspector.all());
        for (const char* text : c.shown) CHECK(inspector.find(text));
        for (const char* text : c.absent) CHECK_FALSE(inspector.find(text));
    }

    inspector.select("wedge");
    inspector.frame();
    const ScreenText* badge = inspector.find("bound outside");
    REQUIRE(badge);
    ImGui::GetIO().MousePos = {badge->at.x + 4, badge->at.y + 6};
    for (int i = 0; i < 3; ++i) inspector.frame();
    INFO(inspector.all());
    CHECK_THAT(inspector.all(), Catch::Contains("may fall short"));
}

TEST_CASE("the inspector has a row for every field of every kind of node") {
    std::string table = "pinfield: 1\nscene:\n";
    for (const NodeType& type : catalog()->types())
        if (type.meta.kind == NodeKind::shape &&
            !std::any_of(type.fields.begin(), type.fields.end(), [](const FieldType& f) { return f.meta.required; }))
            table += "  - " + std::string(type.key()) + ": {id: the_" + std::string(type.key()) + "}\n";
    Inspector inspector(catalog(), table);
    int tried = 0;
    for (const NodeType& type : catalog()->types()) {
        inspector.select("the_" + std::string(type.key()));
        if (inspector.state().selection.empty()) continue;
        inspector.frame();
        ++tried;
        INFO(type.key() << ": " << inspector.all());
        for (const FieldType& field : type.fields) {
            std::string label(field.key);
            std::replace(label.begin(), label.end(), '_', ' ');
            INFO(label);
            CHECK(inspector.find(label));
        }
    }
    CHECK(tried > 10);
}

namespace {

constexpr const char* pins = R"(pinfield: 1
materials:
  rubber: {restitution: 0.8}
scene:
  - circle: {id: a, at: [0.1, 0.2], radius: 10mm, material: rubber}
  - circle: {id: b, at: [0.2, 0.2], radius: 20mm, material: rubber}
  - box: {id: c, at: [0.3, 0.2], size: [10mm, 20mm]}
  - polygon: {id: wedge, points: [[0, 0], [40mm, 0], [0, 40mm]]}
  - mirror: {id: twins, children: [circle: {id: half, at: [0.1, 0.5]}]}
)";

}  // namespace

TEST_CASE("with several nodes selected the inspector shows what they share, says where values differ, and a drag changes all") {
    Inspector inspector(catalog(), pins);
    AppState& state = inspector.state();
    for (const char* id : {"a", "b"}) state.selection.toggle(id_of(state.document, id));
    inspector.frame();
    INFO(inspector.all());
    CHECK(inspector.find("2 nodes"));
    CHECK(inspector.find("2 ? circle"));  // the fixture reads ASCII: a multiplication sign
    CHECK(inspector.find("radius"));
    CHECK_FALSE(inspector.find("id"));
    const ScreenText* radius = inspector.find("mixed");
    REQUIRE(radius);  // of x: 100 and 200; of the radii below it
    CHECK(inspector.find("200"));
    CHECK(inspector.find("rubber"));

    const ScreenText* lower = nullptr;
    for (const ScreenText& text : inspector.seen())
        if (text.text == "mixed" && (!lower || text.at.y < lower->at.y)) lower = &text;
    inspector.drag({lower->at.x + 4, lower->at.y + 6}, 10);
    CHECK(state.document.scene().find("a")->get<double>("radius") == Approx(0.020));
    CHECK(state.document.scene().find("b")->get<double>("radius") == Approx(0.030));
    CHECK(state.document.undo_steps() == 1);

    state.selection.toggle(id_of(state.document, "c"));
    inspector.frame();
    CHECK_FALSE(inspector.find("radius"));
    CHECK(inspector.find("2 ? circle, box"));
}

TEST_CASE("few words stand side by side as buttons, and a click takes one") {
    Inspector inspector(catalog(), pins);
    inspector.select("twins");
    inspector.frame();
    INFO(inspector.all());
    const ScreenText* other = inspector.find("y");
    REQUIRE(inspector.find("x"));
    for (const ScreenText& text : inspector.seen())
        if (text.text == "y" && (!other || text.at.y < other->at.y)) other = &text;
    REQUIRE(other);
    inspector.click({other->at.x + 3, other->at.y + 6});
    CHECK(inspector.state().document.scene().find("twins")->get<std::string>("across") == "y");
}

TEST_CASE("a list of points takes one more by a click") {
    Inspector inspector(catalog(), pins);
    inspector.select("wedge");
    inspector.frame();
    INFO(inspector.all());
    const ScreenText* more = inspector.find("+ point");
    REQUIRE(more);
    inspector.click({more->at.x + 3, more->at.y + 6});
    const auto points = inspector.state().document.scene().find("wedge")->get<std::vector<Vec2>>("points");
    REQUIRE(points.size() == 4);
    CHECK((points[3] - Vec2(-0.02, 0.06)).norm() < 1e-12);
}

TEST_CASE("a material lists the nodes that have it, and a click goes to one") {
    Inspector inspector(catalog(), pins);
    inspector.state().selection.set(inspector.state().document.scene().materials().front());
    inspector.frame();
    INFO(inspector.all());
    CHECK(inspector.find("Used by"));
    const ScreenText* user = inspector.find("b");
    REQUIRE(user);
    inspector.click({user->at.x + 3, user->at.y + 6});
    CHECK(inspector.state().selection.primary() == id_of(inspector.state().document, "b"));
}
