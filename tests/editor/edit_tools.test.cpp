#include "editor/edit_tools.h"
#include "editor/scrub.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "tests/editor/support.h"
#include "tests/places.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

Vec2 world_place(const Document& document, std::string_view node) {
    return world_from_local(document.scene(), id_of(document, node)).offset;
}

/// Tables with every node type in them, each with the parameters its author chose.
std::vector<std::string> example_tables() {
    std::vector<std::string> paths;
    for (const char* folder : {"/scenes/nodes", "/scenes/tables"})
        if (std::filesystem::exists(pinfield::test::source_dir() + folder))
            for (const auto& entry : std::filesystem::directory_iterator(pinfield::test::source_dir() + folder))
                if (entry.path().extension() == ".yaml") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

const Value& value_at(const Document& document, NodeId id, int field) {
    return at(document.scene().find(id)->fields, field).value;
}

void scrub_all_fields(Document& document, NodeId id, CounterRng& rng) {
    const int fields = static_cast<int>(document.scene().find(id)->fields.size());
    for (int field = 0; field < fields; ++field) {
        const Value before = value_at(document, id, field);
        INFO(document.scene().path(id) << ", field " << field);
        // What a template made or an expression says stays as it is.
        const bool is_closed = why_invalid(document.scene(), SetField{id, field, before, true}).has_value();
        for (int i = 0; i < component_count(before); ++i) {
            Scrub scrub;
            REQUIRE(scrub.begin(document, SharedField{{id, field}}, i));
            bool valid = true;
            for (int move = 0; move < 9; ++move) {
                scrub.update(document, std::floor(rng.in(-1, 1) * (move < 4 ? 20 : 1e5)), move % 3 == 0, move % 3 == 1);
                const Value& value = value_at(document, id, field);
                valid = valid && (is_closed ? identical(value, before) : !why_invalid(document.scene(), SetField{id, field, value, true}));
            }
            CHECK(valid);
            scrub.update(document, 0);
            CHECK(identical(value_at(document, id, field), before));
            scrub.cancel(document);
        }
    }
}

}  // namespace

TEST_CASE("a dragged node lands on the grid, and the coordinate that did not move keeps its bits") {
    const Folder folder;
    Document document = opened(folder);
    NodeDrag drag;
    REQUIRE(drag.begin(document, id_of(document, "shelf"), {0.20, 0.31}));
    for (int i = 1; i <= 10; ++i) CHECK_FALSE(drag.update(document, {0.20 + 0.0123 * i, 0.31001}, square_grid(default_grid)));
    CHECK_FALSE(drag.end(document));
    CHECK(identical(document.scene().find("shelf")->value("at"), Value(Vec2(0.373, 0.3))));
    CHECK_THAT(document.source().text(), Catch::Contains("at: [0.373, 300mm]"));
    CHECK(*document.undo_label() == "Move shelf");
    CHECK(changed_lines(pen, document.source().text()) == 1);
}

TEST_CASE("without a grid a node still lands on hundredths of a millimetre") {
    const Folder folder;
    const Document document = opened(folder);
    const SetField edit = moved(document.scene(), id_of(document, "pop"), {0.25, 0.70}, {0.0123456789, 0}, square_grid(0));
    CHECK(identical(edit.value, Value(Vec2(0.26235, 0.70))));
}

TEST_CASE("a node inside a turned and scaled group follows the hand in the world") {
    const Folder folder;
    Document document = opened(folder);
    const Vec2 before = world_place(document, "post");
    NodeDrag drag;
    REQUIRE(drag.begin(document, id_of(document, "post"), before));
    CHECK_FALSE(drag.update(document, before + Vec2(0.03, -0.02), square_grid(default_grid)));
    CHECK_FALSE(drag.end(document));
    const Vec2 moved_by = world_place(document, "post") - before;
    CHECK(moved_by.x() == Approx(0.03).margin(1e-12));
    CHECK(moved_by.y() == Approx(-0.02).margin(1e-12));
    CHECK(changed_lines(pen, document.source().text()) == 1);
}

TEST_CASE("a drag with an axis lock moves along the greater component only") {
    const Folder folder;
    Document document = opened(folder);
    NodeDrag drag;
    REQUIRE(drag.begin(document, id_of(document, "pop"), {0.25, 0.70}));
    CHECK_FALSE(drag.update(document, {0.30, 0.72}, square_grid(default_grid), true));
    CHECK(document.scene().find("pop")->get<Vec2>("at") == Vec2(0.3, 0.70));
    drag.cancel(document);
    CHECK(document.scene().find("pop")->get<Vec2>("at") == Vec2(0.25, 0.70));
    CHECK_FALSE(drag.active());
}

TEST_CASE("a click is no drag, and what is locked or a record does not move") {
    const Folder folder;
    Document document = opened(folder);
    NodeDrag drag;
    REQUIRE(drag.begin(document, id_of(document, "pop"), {0.25, 0.70}));
    CHECK_FALSE(drag.update(document, {0.2501, 0.70}, square_grid(default_grid)));
    CHECK_FALSE(document.previewing());
    CHECK_FALSE(drag.end(document));
    CHECK_FALSE(document.can_undo());
    CHECK_FALSE(drag.begin(document, id_of(document, "nail"), {0, 0}));
    CHECK_FALSE(drag.begin(document, document.scene().table().id, {0, 0}));
}

TEST_CASE("a scrub moves by whole steps, finer with fine, coarser with coarse, and keeps the author's unit") {
    const Folder folder;
    Document document = opened(folder);
    const int radius = *document.scene().find("pop")->type->find_field("radius");
    const auto scrubbed = [&](double pixels, bool fine, bool coarse) {
        Scrub scrub;
        REQUIRE(scrub.begin(document, SharedField{{id_of(document, "pop"), radius}}));
        scrub.update(document, 3);
        scrub.update(document, pixels, fine, coarse);
        REQUIRE_FALSE(scrub.end(document));
        const double value = document.scene().find("pop")->get<double>("radius");
        const std::string text = text_of(document, id_of(document, "pop"), radius);
        document.undo();
        CHECK_FALSE(document.can_undo());
        return std::pair(value, text);
    };
    CHECK(scrubbed(7, false, false) == std::pair(0.031, std::string("31mm")));
    CHECK(scrubbed(-7, true, false) == std::pair(0.0233, std::string("23.3mm")));
    CHECK(scrubbed(2, false, true) == std::pair(0.04, std::string("40mm")));
}

TEST_CASE("a scrub never leaves the valid range, whatever the node and however far it is dragged") {
    CounterRng rng(7);
    for (const std::string& path : example_tables()) {
        INFO(path);
        Document document = *Document::open(path, catalog());
        REQUIRE_FALSE(has_errors(document.diagnostics()));
        const std::string text = document.source().text();
        for (const NodeId id : document.scene().all()) scrub_all_fields(document, id, rng);
        CHECK(document.source().text() == text);
        CHECK_FALSE(document.can_undo());
    }
}

TEST_CASE("a scrub past the end of a range stops at the last step before it") {
    const Folder folder;
    Document document = opened(folder);
    const auto dragged = [&](std::string_view field, double pixels) {
        Scrub scrub;
        REQUIRE(scrub.begin(document, SharedField{{id_of(document, "pop"), *document.scene().find("pop")->type->find_field(field)}}));
        scrub.update(document, pixels);
        const double value = document.scene().find("pop")->get<double>(field);
        scrub.cancel(document);
        return value;
    };
    CHECK(dragged("radius", -1000) == 0.001);  // above 0: the smallest step that is
    CHECK(dragged("kick", -1000) == 0);
    CHECK(dragged("kick", 1e6) == 20);
}

TEST_CASE("a typed value is read as the format reads it, units and all") {
    const Folder folder;
    Document document = opened(folder);
    const NodeId pop = id_of(document, "pop");
    const auto field = [&](std::string_view key) { return *document.scene().find(pop)->type->find_field(key); };
    REQUIRE_FALSE(set_from_text(document, pop, field("radius"), "3cm"));
    CHECK(document.scene().find(pop)->get<double>("radius") == 0.03);
    REQUIRE_FALSE(set_from_text(document, pop, field("at"), "[20cm, 0.75]"));
    CHECK(document.scene().find(pop)->get<Vec2>("at") == Vec2(0.2, 0.75));
    REQUIRE_FALSE(set_from_text(document, pop, field("at"), "0.21, 760mm"));
    CHECK(document.scene().find(pop)->get<Vec2>("at") == Vec2(0.21, 0.76));
    CHECK_THAT(*set_from_text(document, pop, field("radius"), "30deg"), !Catch::Equals(""));
    CHECK(set_from_text(document, pop, field("radius"), "-3mm"));
    CHECK(set_from_text(document, pop, field("radius"), "wide"));
    CHECK(set_from_text(document, pop, field("flip"), "sideways"));
    REQUIRE_FALSE(set_from_text(document, pop, field("flip"), "x"));
    const NodeId rubber = document.scene().materials()[0];
    const int color = *document.scene().find(rubber)->type->find_field("color");
    REQUIRE_FALSE(set_from_text(document, rubber, color, "#7c5"));
    CHECK(document.scene().find(rubber)->get<std::string>("color") == "#7c5");
    CHECK(text_of(document, rubber, color) == "#7c5");
    for (int i = 0; i < 5; ++i) document.undo();
    CHECK(document.source().text() == pen);
}

TEST_CASE("what a field shows for typing over reads back as its value") {
    const Folder folder;
    Document document = opened(folder);
    for (const NodeId id : document.scene().all()) {
        const Node& node = *document.scene().find(id);
        for (std::size_t i = 0; i < node.fields.size(); ++i) {
            const FieldType& field = node.type->fields[i];
            const std::string text = text_of(document, id, static_cast<int>(i));
            if (text.empty()) continue;
            const Result<Value> value = value_of(field, text);
            INFO(node.type->key() << "." << field.key << " = " << text);
            REQUIRE(value);
            CHECK(identical(*value, node.fields[i].value));
        }
    }
}
