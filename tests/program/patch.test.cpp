// The law of patching: a patched program equals the program compiled from the edited scene, bit for bit.
#include "engine/program/patch.h"

#include <array>
#include <catch2/catch.hpp>

#include "engine/core/at.h"
#include "engine/io/load_table.h"
#include "engine/scene/playfield.h"
#include "tests/places.h"
#include "tests/program/same_program.h"
#include "tests/program/tables.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

/// Another value that the field might take.
Value nudged(const FieldType& field, const Value& value, CounterRng& random) {
    Value out = value;
    if (auto* number = std::get_if<double>(&out))
        *number += random.in(-0.2, 0.2) * (std::fabs(*number) + 0.01);
    else if (auto* integer = std::get_if<std::int64_t>(&out))
        *integer += random.uniform() < 0.5 ? 1 : -1;
    else if (auto* flag = std::get_if<bool>(&out))
        *flag = !*flag;
    else if (auto* point = std::get_if<Vec2>(&out))
        *point += Vec2{random.in(-0.01, 0.01), random.in(-0.01, 0.01)};
    else if (auto* points = std::get_if<std::vector<Vec2>>(&out)) {
        if (random.uniform() < 0.3)
            points->push_back(points->back() + Vec2(0.001, 0.002));
        else
            points->front() += Vec2{random.in(-0.002, 0.002), random.in(-0.002, 0.002)};
    } else if (field.kind == FieldKind::choice) {
        out = std::string(
            at(field.choices, random.uniform() * static_cast<double>(field.choices.size())));
    } else if (field.kind == FieldKind::choices) {
        auto words = std::get<std::vector<std::string>>(out);
        if (random.uniform() < 0.3) words.push_back(words.front());
        words.front() = at(field.choices, random.uniform() * static_cast<double>(field.choices.size()));
        out = std::move(words);
    } else if (field.kind == FieldKind::text || field.kind == FieldKind::id) {
        out = std::string(random.uniform() < 0.5 ? "rubber" : "default");
    }
    return out;
}

ProgramPtr patched_by(const Program& before, const Scene& scene, NodeId node, int field) {
    return patch(before, scene, std::array{FieldChange{node, field}});
}

struct Tally {
    int edits = 0, patched = 0;
};

/// Walks through every field of every node; each accepted edit stays, so that patches build on patches.
void check_all_edits(Scene& scene, std::uint64_t seed, Tally& tally) {
    CounterRng random(seed);
    ProgramPtr program = compiled(scene);
    for (const NodeId id : scene.all()) {
        for (std::size_t f = 0; f < scene.find(id)->type->fields.size(); ++f) {
            const Node& node = *scene.find(id);
            SetField edit{id, static_cast<int>(f), nudged(node.type->fields[f], node.fields[f].value, random), true};
            if (why_invalid(scene, edit)) continue;
            const SetField undo = apply(scene, edit);
            const auto fresh = compile(scene);
            const ProgramPtr patched = patched_by(*program, scene, id, edit.field);
            INFO(scene.path(id) << "." << node.type->fields[f].key);
            ++tally.edits;
            if (!fresh) {
                REQUIRE(patched == nullptr);
                apply(scene, undo);
                continue;
            }
            if (patched) {
                ++tally.patched;
                REQUIRE(difference(*patched, **fresh).empty());
                program = patched;
            } else {
                program = *fresh;
            }
        }
    }
}

}  // namespace

TEST_CASE("a patched program equals a recompiled one, whatever field of the playfield changes") {
    Tally tally;
    Scene scene = playfield(catalog(), 40);
    scene.add_material("rubber");
    check_all_edits(scene, 1, tally);
    CHECK(tally.patched > 300);
}

TEST_CASE("a patched program equals a recompiled one, whatever field of a random tree changes") {
    Tally tally;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        Scene scene(catalog());
        scene.add_material("rubber");
        const NodeId group = add(scene, "group", {}, {{"at", Vec2(0.2, 0.3)}});
        for (int i = 0; i < 3; ++i)
            RandomTree(scene, seed * 7 + static_cast<std::uint64_t>(i), seed % 2 == 0)
                .grow(i == 1 ? group : NodeId{}, i);
        const NodeId blend = add(scene, "smooth_union", group);
        add(scene, "circle", blend);
        add(scene, seed % 5 == 0 ? "ellipse" : "box", blend, {{"at", Vec2(0.03, 0)}});  // an ellipse takes ten times as long to trace
        scene.inputs.push_back({"left", {"Z"}, {}});
        add(scene, "flipper", group, {{"input", std::vector<std::string>{"left"}}, {"flip", std::string("x")}});
        add(scene, "plunger", {}, {{"turn", 12.0}});
        add(scene, "bumper", group);
        add(scene, "drain");
        add(scene, "spawn");
        check_all_edits(scene, seed, tally);
    }
    CHECK(tally.patched > 2000);
}

TEST_CASE("a patched program equals a recompiled one, whatever field of the first table changes") {
    auto table = load_table(test::source_dir() + "/scenes/tables/first_table.yaml", catalog());
    REQUIRE(table);
    REQUIRE(table->ok());
    Tally tally;
    check_all_edits(table->scene, 3, tally);
    CHECK(tally.patched > 400);
}

TEST_CASE("many fields that change at once are patched as one, and equal a recompiled program") {
    auto table = load_table(test::source_dir() + "/scenes/tables/first_table.yaml", catalog());
    REQUIRE(table);
    Scene& scene = table->scene;
    CounterRng random(11);
    ProgramPtr program = compiled(scene);
    int patched_rounds = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<FieldChange> changes;
        std::vector<SetField> undo;
        for (const NodeId id : scene.all()) {
            if (random.uniform() < 0.7) continue;
            const Node& node = *scene.find(id);
            const int f = static_cast<int>(random.uniform() * static_cast<double>(node.fields.size()));
            if (at(node.type->fields, f).meta.affects == Affects::structure) continue;
            const SetField edit{id, f, nudged(at(node.type->fields, f), at(node.fields, f).value, random), true};
            if (why_invalid(scene, edit)) continue;
            undo.push_back(apply(scene, edit));
            changes.push_back({id, f});
        }
        REQUIRE(changes.size() > 5);
        const auto fresh = compile(scene);
        const ProgramPtr patched = patch(*program, scene, changes);
        REQUIRE((patched == nullptr || fresh));
        if (patched) {
            ++patched_rounds;
            REQUIRE(difference(*patched, **fresh).empty());
        }
        if (fresh) program = *fresh;
        else
            for (auto edit = undo.rbegin(); edit != undo.rend(); ++edit) apply(scene, *edit);
    }
    CHECK(patched_rounds > 30);
}

TEST_CASE("an edit that changes names or layers is left to compile") {
    Scene scene(catalog());
    const NodeId disc = add(scene, "circle");
    const ProgramPtr program = compiled(scene);
    CHECK(patched_by(*program, scene, disc, *scene.find(disc)->type->find_field("layer")) == nullptr);
    CHECK(patched_by(*program, scene, disc, *scene.find(disc)->type->find_field("id")) == nullptr);
    CHECK(patched_by(*program, scene, disc, *scene.find(disc)->type->find_field("at")) != nullptr);
}
