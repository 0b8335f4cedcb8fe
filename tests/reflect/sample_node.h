// A described struct with a field of every kind that a formula can read.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/reflect/describe.h"

namespace pinfield {

enum class Fruit : unsigned char { apple, pear, plum };
constexpr std::array<std::string_view, 3> choice_names(Fruit) { return {"apple", "pear", "plum"}; }

template <class Real>
struct Basket {
    static constexpr double example[] = {1, 2, 3, 4, 5, 6};

    bool open = true;
    int count = 3;
    Real weight = Real(2.5);
    Point<Real> at{Real(0.25), Real(-0.5)};
    Fruit fruit = Fruit::pear;
    PointList<Real> handles{example, 3};
    std::string label = "mine";
    std::vector<std::string> owners{};
    static constexpr double usual[] = {2, 0};
    ChoiceList<Fruit> layers{usual, 2};
    double total = 0;  // derived

    static constexpr auto derived() { return std::tuple(&Basket::total); }
    void derive() { total = count * weight; }

    static constexpr auto describe() {
        using B = Basket;
        return record<B>({.key = "basket", .doc = "For tests."},
                         fields(field("open", &B::open, {.doc = "Has no lid."}),
                                field("count", &B::count, {.min = from(0), .max = to(10), .doc = "How many."}),
                                field("weight", &B::weight, {.unit = Unit::kilogram, .min = above(0), .max = below(5), .doc = "Of each."}),
                                field("at", &B::at, {.unit = Unit::metre, .min = from(-1), .doc = "Where."}),
                                field("fruit", &B::fruit, {.doc = "Which."}),
                                field("handles", &B::handles, {.unit = Unit::metre, .required = true, .doc = "Where to hold it."}),
                                field("label", &B::label, {.meaning = Meaning::id, .doc = "Its name."}),
                                field("owners", &B::owners, {.doc = "Whose it is."}),
                                field("layers", &B::layers, {.doc = "From below."})),
                         contract("no more than 12 kg", [](const auto& b) { return b.count * b.weight <= 12; }),
                         contract("at least one handle", [](const auto& b) { return b.handles.count > 0; }));
    }
};

}  // namespace pinfield
