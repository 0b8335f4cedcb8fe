// Random solids of every operator over every other, with walls, pins and gaps far thinner than the whole.
#pragma once
#include "tests/program/tables.h"

namespace pinfield::test {

/// Pairs are drawn between braces, in which every compiler goes from left to right.
class RandomConstruction {
public:
    /// `thinnest`: of walls and pins, in sizes of the solid, which is about half a metre large.
    /// Without `curves` all shapes have outlines of lines and arcs.
    RandomConstruction(Scene& scene, std::uint64_t seed, double thinnest, bool curves = true)
        : scene_(scene), random_(seed), thinnest_(thinnest), curves_(curves) {}

    NodeId grow(NodeId parent, int depth) {
        if (depth == 0) return leaf(parent);
        static constexpr std::string_view folds[] = {"union", "intersection", "difference", "xor", "smooth_union", "smooth_intersection",
                                                     "smooth_difference", "lerp"};
        static constexpr std::string_view others[] = {"stretch", "twist", "bend", "displace", "elongate", "onion", "round", "inset",
                                                      "mirror", "repeat_polar", "complement"};
        const bool folds_some = random_.uniform() < 0.55;
        const std::string_view operation = folds_some ? folds[pick(8)] : others[pick(depth > 1 ? 11 : 10)];
        const NodeId id = add(scene_, operation, parent);
        place(id, 0.05);
        configure(*scene_.find(id));
        const int children = !folds_some ? 1 : operation == "lerp" ? 2 : 2 + pick(2);
        for (int i = 0; i < children; ++i) grow(id, i == 0 ? depth - 1 : pick(depth));
        return id;
    }

private:
    int pick(int n) { return static_cast<int>(random_.uniform() * n); }

    /// From the thinnest to a tenth of the solid, as likely in each power of ten.
    double thickness() { return 0.5 * thinnest_ * std::pow(0.1 / thinnest_, random_.uniform()); }

    void place(NodeId id, double spread) {
        Node& node = *scene_.find(id);
        const double x = random_.in(-spread, spread);
        set(node, "at", Vec2(x, random_.in(-spread, spread)));
        if (pick(2) == 0) set(node, "turn", random_.in(-180, 180));
        if (pick(4) == 0) set(node, "flip", std::string(pick(2) ? "x" : "y"));
    }

    void configure(Node& node) {
        const std::string_view key = node.type->key();
        if (key.starts_with("smooth")) set(node, "k", thickness());
        if (key == "lerp") set(node, "t", random_.in(0.2, 0.8));
        if (key == "stretch") {
            const double x = random_.in(0.6, 1.6);
            set(node, "by", Vec2(x, random_.in(0.6, 1.6)));
        }
        if (key == "twist") set(node, "angle", random_.in(-60, 60)), set(node, "radius", 0.4);
        if (key == "bend") set(node, "sag", random_.in(-0.1, 0.1)), set(node, "length", 0.5);
        if (key == "displace") {
            set(node, "amplitude", random_.in(0.0002, 0.003));
            const double x = random_.in(0.05, 0.2);
            set(node, "wavelength", Vec2(x, random_.in(0.05, 0.2)));
        }
        if (key == "elongate") set(node, "by", Vec2{thickness(), thickness()});
        if (key == "onion") set(node, "thickness", thickness());
        if (key == "round") set(node, "radius", thickness());
        if (key == "inset") set(node, "distance", 0.1 * thickness());
        if (key == "repeat_polar") set(node, "count", std::int64_t{2} + pick(4));
    }

    NodeId leaf(NodeId parent) {
        NodeId id;
        switch (pick(curves_ ? 6 : 5)) {
            case 0: id = add(scene_, "box", parent, {{"size", Vec2{random_.in(0.2, 0.5), thickness()}}}); break;
            case 1: id = add(scene_, "circle", parent, {{"radius", 0.5 * thickness()}}); break;
            case 2: id = add(scene_, "box", parent, {{"size", Vec2{random_.in(0.1, 0.3), random_.in(0.1, 0.3)}}}); break;
            case 3: id = add(scene_, "ring", parent, {{"radius", random_.in(0.1, 0.2)}, {"thickness", std::max(thickness(), 0.0003)}}); break;
            case 4: id = add(scene_, "capsule", parent, {{"length", random_.in(0.1, 0.3)}, {"radius", 0.5 * thickness()}}); break;
            default: id = add(scene_, "ellipse", parent, {{"radii", Vec2{random_.in(0.1, 0.25), random_.in(0.03, 0.1)}}}); break;
        }
        place(id, 0.1);
        return id;
    }

    Scene& scene_;
    CounterRng random_;
    double thinnest_;
    bool curves_;
};

}  // namespace pinfield::test
