// Rulers, guides, and what keeps them.
#include "editor/guides.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "editor/keep_preferences.h"
#include "editor/pick.h"
#include "editor/table_aids.h"
#include "engine/core/numbers.h"
#include "tests/editor/desk.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

const std::string disc = R"(pinfield: 1
table: {size: [1, 1]}
scene:
  - domain: {id: hall, children: [box: {id: room, size: [0.9, 0.9], at: [0.5, 0.5]}]}
  - circle: {id: a, at: [0.3, 0.7], radius: 40mm}
)";

/// The table with its rulers.
class RuledDesk : public Desk {
public:
    RuledDesk() : Desk(disc) {
        state_.preferences.show_rulers = true;
        frames(1);
    }
};

}  // namespace

TEST_CASE("at every zoom labels are round, far enough apart, and no farther than need be") {
    for (int power = 0; power < 147; ++power) {
        const double zoom = 10 * std::pow(1.07, power);  // to 200 000
        const RulerScale scale = ruler_scale(zoom, 56);
        INFO(zoom << " pixels a metre: " << scale.step);
        CHECK(scale.step * zoom >= 56);
        CHECK(scale.step * zoom < 56 * 2.5 * (1 + 1e-9));
        CHECK(scale.step / scale.parts * zoom >= 4);
        const double leading = scale.step / std::pow(10, std::floor(std::log10(scale.step) + 1e-9));
        CHECK((leading == Approx(1) || leading == Approx(2) || leading == Approx(5)));
        CHECK(scale.label(0) == "0");
        // A label is the number that stands there.
        for (const long long i : {1LL, 3LL, 17LL}) {
            const double shown = *parse_number(scale.label(i)) * (scale.unit() == std::string("m") ? 1 : 1e-3);
            CHECK(shown == Approx(static_cast<double>(i) * scale.step).epsilon(1e-12));
        }
    }
}

TEST_CASE("a guide is found by the distance to its line, the nearest first") {
    const std::vector<Guide> guides{{0, 0.2}, {1, 0.3}, {0, 0.21}};
    CHECK(guide_at(guides, {0.206, 0.9}, 0.01) == 2);
    CHECK(guide_at(guides, {0.204, 0.9}, 0.01) == 0);
    CHECK(guide_at(guides, {0.5, 0.305}, 0.01) == 1);
    CHECK_FALSE(guide_at(guides, {0.5, 0.5}, 0.01));
}

TEST_CASE("a guide comes in line with edges and middles, else it goes by the grid") {
    const std::vector<Box2> boxes{{{0.1004, 0.2}, {0.3, 0.4}}};
    CHECK(guide_place(0.103, 0, boxes, 0.005, 0.001) == 0.1004);
    CHECK(guide_place(0.2, 0, boxes, 0.005, 0.001) == Approx(0.2002).margin(1e-15));
    CHECK(guide_place(0.1217, 0, boxes, 0.005, 0.001) == 0.122);
    CHECK(guide_place(0.2993, 1, boxes, 0.005, 0.001) == Approx(0.3).margin(1e-15));
}

TEST_CASE("guides are drawn out of rulers, moved, and put back there to be gone; the table's text does not change") {
    RuledDesk desk;
    const std::string text = desk.state().document.source().text();
    desk.drag({400, 8}, desk.on_table(0.5, 0.6));
    REQUIRE(desk.state().aids.guides.size() == 1);
    CHECK(desk.state().aids.guides[0].axis == 1);
    CHECK(desk.state().aids.guides[0].at == Approx(0.6).margin(2e-3));
    desk.drag({10, 400}, desk.on_table(0.452, 0.2));
    REQUIRE(desk.state().aids.guides.size() == 2);
    CHECK(desk.state().aids.guides[1].axis == 0);
    CHECK(desk.state().aids.guides[1].at == Approx(0.452).margin(2e-3));
    desk.drag(desk.on_table(0.8, 0.6), desk.on_table(0.8, 0.3));
    CHECK(desk.state().aids.guides[0].at == Approx(0.3).margin(2e-3));
    desk.drag(desk.on_table(0.8, 0.3), {500, 5});
    REQUIRE(desk.state().aids.guides.size() == 1);
    CHECK(desk.state().aids.guides[0].axis == 0);
    CHECK(desk.state().document.source().text() == text);
    CHECK_FALSE(desk.state().document.can_undo());
}

TEST_CASE("Esc puts a guide back where it was, and takes a new one away") {
    RuledDesk desk;
    desk.state().aids.guides = {{0, 0.6}};
    desk.move_to(desk.on_table(0.6, 0.3));
    desk.button(true);
    desk.move_to(desk.on_table(0.7, 0.3));
    CHECK(desk.state().aids.guides[0].at == Approx(0.7).margin(2e-3));
    CHECK(cancel_drag(desk.state(), desk.ui()));
    CHECK(desk.state().aids.guides[0].at == 0.6);
    desk.button(false);
    desk.move_to({400, 8});
    desk.button(true);
    desk.move_to(desk.on_table(0.5, 0.5));
    REQUIRE(desk.state().aids.guides.size() == 2);
    CHECK(cancel_drag(desk.state(), desk.ui()));
    desk.button(false);
    CHECK(desk.state().aids.guides == std::vector<Guide>{{0, 0.6}});
}

TEST_CASE("a node that is dragged near a guide comes in line with it to 1e-9; hidden guides hold nothing, and locked ones stay") {
    const auto dropped = [](bool shown) {
        RuledDesk desk;
        desk.state().aids.guides = {{0, 0.5123456}};
        desk.state().preferences.show_guides = shown;
        desk.drag(desk.on_table(0.3, 0.7), desk.on_table(0.5132, 0.62));
        return desk.state().document.scene().find("a")->get<Vec2>("at");
    };
    CHECK(std::fabs(dropped(true).x() - 0.5123456) <= 1e-9);
    CHECK(std::fabs(dropped(false).x() - 0.5123456) > 1e-5);
    RuledDesk desk;
    desk.state().aids.guides = {{0, 0.6}};
    run(desk.state(), "view.lock_guides");
    desk.drag(desk.on_table(0.6, 0.3), desk.on_table(0.7, 0.3));
    CHECK(desk.state().aids.guides == std::vector<Guide>{{0, 0.6}});
}

TEST_CASE("a node comes in line with the axis of a mirror, wherever that stands, but not with its own") {
    const Folder folder;
    const AppState state =
        opened_state(folder, disc + R"(  - mirror: {id: m, at: [0.4321, 0.2], children: [circle: {id: half, at: [0.1, 0], radius: 20mm}]}
  - mirror: {id: turned, at: [0.4, 0.3], turn: 20, children: [circle: {at: [0.1, 0], radius: 20mm}]}
  - mirror: {id: level, across: y, at: [0.4, 0.6543], children: [circle: {at: [0.1, 0.05], radius: 20mm}]}
)");
    const std::vector<Box2> axes = mirror_axes(state, {id_of(state.document, "a")});
    REQUIRE(axes.size() == 2);
    CHECK(axes[0].lo.x() == Approx(0.4321).margin(1e-12));
    CHECK(axes[0].hi.x() == axes[0].lo.x());
    CHECK(axes[1].lo.y() == Approx(0.6543).margin(1e-12));
    CHECK(axes[1].hi.y() == axes[1].lo.y());
    CHECK(mirror_axes(state, {id_of(state.document, "m"), id_of(state.document, "level")}).empty());
}

TEST_CASE("where a node is under the mouse, that is dragged and not the guide") {
    RuledDesk desk;
    desk.state().aids.guides = {{0, 0.3}};
    desk.drag(desk.on_table(0.3, 0.7), desk.on_table(0.42, 0.55));
    CHECK(desk.state().aids.guides == std::vector<Guide>{{0, 0.3}});
    CHECK(desk.state().document.can_undo());
}

TEST_CASE("guides are kept for each table beside the preferences, and follow it to another name") {
    const Folder folder;
    const std::string first = folder.write("a.yaml", disc), second = folder.write("b.yaml", disc), config = folder.file("config");
    const std::vector<Guide> guides{{0, 0.125}, {1, -0.003}, {0, 1.0 / 3}};
    {
        AppState state(catalog(), *Document::open(first, catalog()));
        load_preferences(state, config);
        CHECK(state.aids.guides.empty());
        state.aids.guides = guides;
        keep_preferences(state);
        open_file(state, second);
        CHECK(state.aids.guides.empty());
        open_file(state, first);
        CHECK(state.aids.guides == guides);
        run(state, "file.save_as");
        state.dialog_path = folder.file("c.yaml");
        run(state, "dialog.accept");
        keep_preferences(state);
        run(state, "guide.clear");
        keep_preferences(state);
        open_file(state, first);
        CHECK(state.aids.guides == guides);
    }
    AppState state(catalog(), *Document::open(folder.file("c.yaml"), catalog()));
    load_preferences(state, config);
    CHECK(state.aids.guides.empty());
    CHECK(folder.read("a.yaml") == disc);
}

TEST_CASE("files of guides are read as far as they can be, and never too many of them are kept") {
    CHECK(
        read_aids("table: x\nguide: x 120mm\nguide: z 1\nguide:\nguide: y\nguide: y 0.5\r\nguide: y 1e9\nguide: x nan\nwhat\nguide: y 0.5")
            .guides == std::vector<Guide>{{0, 0.12}, {1, 0.5}});
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "guide: x 1mm\n";
    CHECK(read_aids(many).guides.size() == most_guides);
    const Folder folder;
    const auto count = [&] {
        return std::distance(std::filesystem::directory_iterator(folder.file("tables")), std::filesystem::directory_iterator{});
    };
    AidsFolder aids(folder.file("tables"));
    for (int i = 0; i < 210; ++i) {
        aids.open("/t/" + std::to_string(i));
        aids.keep("/t/" + std::to_string(i), {.guides = {{0, 0.1}}});
    }
    CHECK(count() == 200);
}

TEST_CASE("without a folder guides are the run's own") {
    AidsFolder aids;
    aids.keep("/t/a", {.guides = {{0, 0.1}}});
    CHECK(aids.open("/t/a").guides.empty());
}
