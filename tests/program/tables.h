// Small scenes for the tests of the program layer, and random ones.
#pragma once
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/at.h"
#include "engine/core/rng.h"
#include "engine/program/compile.h"
#include "engine/scene/catalog.h"
#include "engine/scene/scene.h"

namespace pinfield::test {

inline std::shared_ptr<const Catalog> catalog() {
    static const auto shared = std::make_shared<const Catalog>(built_in_catalog());
    return shared;
}

using Fields = std::vector<std::pair<std::string_view, Value>>;

inline void set(Node& node, std::string_view key, Value value) {
    FieldSlot& slot = at(node.fields, *node.type->find_field(key));
    slot.value = std::move(value);
    slot.is_explicit = true;
}

inline NodeId add(Scene& scene, std::string_view key, NodeId parent = {}, const Fields& fields = {}) {
    Node& node = scene.add(*scene.catalog().find(key), parent);
    for (const auto& [field, value] : fields) set(node, field, value);
    return node.id;
}

/// A table that must compile.
inline ProgramPtr compiled(const Scene& scene) {
    const auto program = compile(scene);
    if (!program) throw std::runtime_error(program.error().empty() ? "no reason" : program.error()[0].message);
    return *program;
}

/// The only solid that is not the domain.
inline int first_shape(const Program& program) {
    for (std::size_t i = 0; i < program.fixed.solids.size(); ++i)
        if (program.fixed.solids[i].bounds.is_finite()) return static_cast<int>(i);
    return -1;
}

/// Random CSG trees of line-and-arc shapes. With `snapped` places, sizes and angles come from a coarse grid, so that
/// shared edges, tangencies and identical children abound. A `slender` tree is deep by its first children only.
class RandomTree {
public:
    RandomTree(Scene& scene, std::uint64_t seed, bool snapped, bool slender = false)
        : scene_(scene), random_(seed), snapped_(snapped), slender_(slender) {}

    NodeId grow(NodeId parent, int depth) {
        if (depth == 0) return leaf(parent);
        static constexpr std::string_view operations[] = {"union",      "intersection", "difference",  "xor",
                                                          "complement", "mirror",       "repeat_polar"};
        const std::string_view operation = operations[pick(depth > 1 ? 7 : 5)];
        const NodeId id = add(scene_, operation, parent);
        place(id, 0.5);
        const bool unary = operation == "complement" || operation == "mirror" || operation == "repeat_polar";
        if (operation == "repeat_polar") set(*scene_.find(id), "count", std::int64_t{2} + pick(4));
        const int children = unary ? 1 : 2 + pick(2);
        for (int i = 0; i < children; ++i) grow(id, slender_ && i > 0 ? std::min(depth - 1, pick(2)) : depth - 1);
        return id;
    }

    int pick(int n) { return static_cast<int>(random_.uniform() * n); }
    double number(double lo, double hi, double step) {
        const double v = random_.in(lo, hi);
        return snapped_ ? std::max(std::floor(v / step), 1.0) * step : v;
    }

private:
    void place(NodeId id, double spread) {
        Node& node = *scene_.find(id);
        const double x = random_.in(-spread, spread), y = random_.in(-spread, spread);
        set(node, "at", snapped_ ? Vec2(0.1 * std::floor(10 * x), 0.1 * std::floor(10 * y)) : Vec2(x, y));
        set(node, "turn", snapped_ ? 45.0 * pick(8) : random_.in(-180, 180));
        if (pick(3) == 0) set(node, "flip", std::string(pick(2) ? "x" : "y"));
        if (pick(4) == 0) set(node, "scale", snapped_ ? 0.5 : random_.in(0.5, 1.5));
    }

    NodeId leaf(NodeId parent) {
        NodeId id;
        switch (pick(7)) {
            case 0: id = add(scene_, "circle", parent, {{"radius", number(0.1, 0.5, 0.1)}}); break;
            case 1: {
                const double w = number(0.2, 0.8, 0.2), h = number(0.2, 0.8, 0.2);
                id = add(scene_, "box", parent,
                         {{"size", Vec2(w, h)}, {"round", pick(2) ? 0.0 : 0.25 * std::min(w, h)}});
                break;
            }
            case 2:
                id = add(scene_, "capsule", parent,
                         {{"length", number(0.1, 0.6, 0.1)}, {"radius", number(0.1, 0.3, 0.1)}});
                break;
            case 3:
                id = add(scene_, "regular_polygon", parent,
                         {{"sides", std::int64_t{3} + pick(4)}, {"radius", number(0.2, 0.5, 0.1)}});
                break;
            case 4:
                id = add(scene_, "triangle", parent,
                         {{"a", Vec2(-0.2, -0.2)},
                          {"b", Vec2(number(0.1, 0.4, 0.1), -0.2)},
                          {"c", Vec2(-0.2, number(0.1, 0.4, 0.1))}});
                break;
            case 5: {  // a box with one round end
                const double w = number(0.1, 0.3, 0.1), h = number(0.1, 0.3, 0.1);
                id = add(scene_, "path", parent,
                         {{"points", std::vector<Vec2>{{-w, -h}, {w, -h}, {w + h, 0}, {w, h}, {-w, h}}},
                          {"pieces", std::vector<std::string>{"line", "arc", "line"}},
                          {"fill", true},
                          {"thickness", 0.0}});
                break;
            }
            default:
                id = add(scene_, "arc", parent,
                         {{"radius", number(0.2, 0.4, 0.1)},
                          {"from", 0.0},
                          {"to", 90.0 * (1 + pick(4))},
                          {"thickness", 0.1}});
                break;
        }
        place(id, 0.3);
        return id;
    }

    Scene& scene_;
    CounterRng random_;
    bool snapped_, slender_;
};

}  // namespace pinfield::test
