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
