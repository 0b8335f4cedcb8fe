// One judgement for reader, compiler and editor: what each of them says of the same mistake, and that no way in lets one pass.
#include "engine/scene/validate.h"

#include <catch2/catch.hpp>

#include "engine/core/error_codes.h"
#include "engine/io/table_reader.h"
#include "engine/program/compile.h"
#include "engine/scene/catalog.h"
#include "engine/scene/edit.h"

using namespace pinfield;

namespace {

std::shared_ptr<const Catalog> catalog() {
    static const auto shared = std::make_shared<const Catalog>(built_in_catalog());
    return shared;
}

Node& add(Scene& scene, std::string_view type, NodeId parent = {}) { return scene.add(*catalog()->find(type), parent); }

/// As a program would, past every check.
void set(Scene& scene, NodeId id, std::string_view key, const Value& value) {
    Node& node = *scene.find(id);
    FieldSlot& slot = node.fields[static_cast<std::size_t>(*node.type->find_field(key))];
    slot.value = value;
    slot.is_explicit = true;
    if (key == "id") node.name = std::get<std::string>(value);
}

/// One mistake, as text and as a program makes it.
struct Mistake {
    const char* name;
    Code code;
    const char* text;  ///< of `scene:` and what follows it
    void (*make)(Scene& scene);
};

const std::vector<Mistake>& mistakes() {
    static const std::vector<Mistake> all{
        {"too few children", Code::child_count, "  - lerp: {children: [circle: {}]}\n",
         [](Scene& scene) { add(scene, "circle", add(scene, "lerp").id); }},
        {"a part among shapes", Code::misplaced_part, "  - union: {children: [bumper: {}, circle: {}]}\n",
         [](Scene& scene) {
             const NodeId parent = add(scene, "union").id;
             add(scene, "bumper", parent);
             add(scene, "circle", parent);
         }},
        {"a broken contract", Code::broken_contract, "  - box: {size: [1cm, 1cm], round: 3cm}\n",
         [](Scene& scene) {
             const NodeId box = add(scene, "box").id;
             set(scene, box, "size", Vec2(0.01, 0.01));
             set(scene, box, "round", 0.03);
         }},
        {"an id said twice", Code::duplicate_id, "  - circle: {id: a}\n  - circle: {id: a}\n",
         [](Scene& scene) {
             for (int i = 0; i < 2; ++i) set(scene, add(scene, "circle").id, "id", std::string("a"));
         }},
        {"an input's name as an id", Code::duplicate_id, "  - circle: {id: left}\ninputs: {left: Z}\n",
         [](Scene& scene) {
             scene.inputs.push_back({"left", {"Z"}, {}});
             set(scene, add(scene, "circle").id, "id", std::string("left"));
         }},
        {"a material that there is none of", Code::unknown_material, "  - circle: {material: gold}\n",
         [](Scene& scene) { set(scene, add(scene, "circle").id, "material", std::string("gold")); }},
        {"an input that there is none of", Code::unknown_input, "  - flipper: {input: left}\n",
         [](Scene& scene) { set(scene, add(scene, "flipper").id, "input", std::vector<std::string>{"left"}); }},
        {"two domains on the ground", Code::second_domain, "  - domain: {children: [circle: {}]}\n  - domain: {children: [box: {}], layer: ground}\n",
         [](Scene& scene) {
             add(scene, "circle", add(scene, "domain").id);
             const NodeId second = add(scene, "domain").id;
             set(scene, second, "layer", std::vector<std::string>{"ground"});
             add(scene, "box", second);
         }},
        {"two domains on a group's layer", Code::second_domain,
         "  - group: {layer: up, children: [domain: {children: [circle: {}]}]}\n  - domain: {layer: up, children: [box: {}]}\n",
         [](Scene& scene) {
             const NodeId group = add(scene, "group").id;
             set(scene, group, "layer", std::vector<std::string>{"up"});
             add(scene, "circle", add(scene, "domain", group).id);
             const NodeId second = add(scene, "domain").id;
             set(scene, second, "layer", std::vector<std::string>{"up"});
             add(scene, "box", second);
         }},
    };
    return all;
}

std::vector<std::string> errors_of(const Diagnostics& found) {
    std::vector<std::string> out;
    for (const Diagnostic& d : found)
        if (d.severity == Severity::error) out.push_back(d.code + " " + d.message);
    return out;
}

}  // namespace

TEST_CASE("reader and compiler say the same of the same mistake") {
    for (const Mistake& mistake : mistakes()) {
        INFO(mistake.name);
        const auto source = std::make_shared<const SourceText>("t.yaml", std::string("pinfield: 1\nscene:\n") + mistake.text);
        const std::vector<std::string> read = errors_of(read_table(source, catalog()).diagnostics);
        Scene scene(catalog());
        mistake.make(scene);
        const auto program = compile(scene);
        REQUIRE_FALSE(program);
        CHECK(errors_of(program.error()) == read);
        REQUIRE(read.size() == 1);
        CHECK(read[0].substr(0, 5) == entry(mistake.code).code);
        CHECK_FALSE(program.error()[0].where);
        CHECK(format(program.error()[0], scene.sources).starts_with("error: "));
    }
}

TEST_CASE("an edit is refused in the words the reader would use") {
    Scene scene(catalog());
    scene.inputs.push_back({"left", {"Z"}, {}});
    const NodeId circle = add(scene, "circle").id, flipper = add(scene, "flipper").id;
    const auto why = [&](NodeId id, std::string_view key, const Value& value) {
        return why_invalid(scene, {id, *scene.find(id)->type->find_field(key), value, true}).value_or("");
    };
    CHECK(why(circle, "material", std::string("gold")) == "no material is called gold");
    CHECK(why(flipper, "input", std::vector<std::string>{"lift"}) == "no input is called lift");
    CHECK(why(flipper, "input", std::vector<std::string>{"left"}).empty());
    CHECK(why(circle, "id", std::string("left")) == "the id left is taken");
    CHECK(why(circle, "id", std::string("right")).empty());
    scene.add_material("gold");
    CHECK(why(circle, "material", std::string("gold")).empty());
}

TEST_CASE("domains on layers of their own are no mistake, whether they or their groups name them") {
    Scene scene(catalog());
    add(scene, "circle", add(scene, "domain").id);
    const NodeId group = add(scene, "group").id;
    set(scene, group, "layer", std::vector<std::string>{"up"});
    add(scene, "circle", add(scene, "domain", group).id);
    CHECK(errors_of(validate(scene)).empty());
    CHECK(compile(scene));
}
