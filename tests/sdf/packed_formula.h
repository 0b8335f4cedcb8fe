// A formula's text as a node would hold it.
#pragma once
#include <catch2/catch.hpp>

#include <string_view>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/text_fault.h"
#include "engine/sdf/steps.h"

namespace pinfield::test {

/// The reals of a text, and the view of them.
struct PackedFormula {
    explicit PackedFormula(std::string_view text) {
        const auto fault = sdf::Steps::pack(text, reals);
        if (fault) FAIL(fault->message);
        steps.reals = reals.data();
        steps.count = static_cast<int>(reals.size());
    }
    PackedFormula(const PackedFormula&) = delete;
    PackedFormula& operator=(const PackedFormula&) = delete;

    double value(const Vec2& p) const { return sdf::value_at(steps, Point<double>{p.x(), p.y()}); }

    std::vector<double> reals;
    sdf::Steps steps;
};

}  // namespace pinfield::test
