#include "tests/conformance/laws.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/core/rng.h"
#include "tests/conformance/brute_force.h"

namespace pinfield::conformance {
namespace {

constexpr std::array all_laws{
    Law{"everything is finite", everything_is_finite},
    Law{"the value alone is the value with its gradient", value_alone_is_value_with_gradient},
    Law{"the gradient is a unit vector where the distance is exact", gradient_is_unit_where_exact},
    Law{"the gradient is the central difference", gradient_is_the_central_difference},
    Law{"the gradient is within the Lipschitz constant", gradient_is_within_lipschitz},
    Law{"the field changes no faster than its Lipschitz constant", field_is_lipschitz},
    Law{"the field is not zero on an area", field_is_not_zero_on_an_area},
    Law{"the disc of safe distance holds no surface", safe_disc_holds_no_surface},
    Law{"the bounds contain the solid", bounds_contain_the_solid},
    Law{"the bounds of a shape are tight", bounds_of_a_shape_are_tight},
    Law{"exact sides are brute-force distances", exact_sides_are_brute_force_distances},
    Law{"no side over-estimates", no_side_overestimates},
    Law{"the sign tells inside from outside", sign_tells_inside_from_outside},
    Law{"the solid is on the left of its outline", solid_is_on_the_left_of_its_outline},
    Law{"the gradient on the outline points out", gradient_on_the_outline_points_out},
    Law{"the foot point is on the outline where the distance is exact", foot_point_is_on_the_outline_where_exact},
    Law{"another size is the same figure in proportion", size_is_a_matter_of_scale},
    Law{"the order of a symmetric fold's children is no matter", order_of_children_is_no_matter},
    Law{"the order of a chain's points is no matter", order_of_points_is_no_matter},
    Law{"packets are the value within the declared float error", packets_are_the_value_within_float_error},
    Law{"every instruction set gives the same bits", every_instruction_set_gives_the_same_bits},
    Law{"a warp's packets send points where the warp does", warp_packets_are_the_warp},
    Law{"a fold strays no further than its slack", fold_strays_no_further_than_its_slack},
    Law{"a fold's partial derivatives are its differences", fold_partials_are_weights_of_differences},
    Law{"a modifier is what its affine form says", modify_is_what_its_affine_form_says},
    Law{"the exactness at defaults is as described", exactness_at_defaults_is_as_described},
    Law{"an enclosure over a box holds the samples in it", enclosures_hold_the_samples},
    Law{"no enclosure of the gradient refutes the Lipschitz constant", enclosures_do_not_refute_the_lipschitz_constant},
};

constexpr std::size_t most_reported = 3;  // of one law for one subject

void add_special_points(const Subject& subject, const sdf::Outline& pieces, double e, std::vector<Vec2>& out) {
    for (const double r : {0.0, 0.25, 0.5, 1.0, 1.5, 4.0})
        for (const Vec2& direction : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1), Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)})
            out.emplace_back(r * e * direction);
    out.emplace_back(1e-200, -1e-200);
    out.emplace_back(1e-17 * e, 1e-18 * e);
    for (const sdf::Piece& piece : pieces) {
        out.insert(out.end(), {piece.a, piece.b, 0.5 * (piece.a + piece.b)});
        if (piece.is_arc()) out.push_back(piece.centre);
        if (out.size() > 160) break;
    }
    const Box2 box = subject.bounds();
    if (box.is_finite() && !box.is_empty())
        for (const Vec2& p : {box.lo, box.hi, box.centre(), Vec2(box.lo.x(), box.centre().y())}) out.push_back(p);
}

}  // namespace

Trial trial_of(const Subject& subject, const Witness& witness, std::uint64_t seed, std::size_t random_count) {
    Trial trial{subject, witness, subject.extent(), subject.exactness()};
    CounterRng rng(seed);
    const Box2 bounds = subject.bounds(), around = Box2::centred(3 * trial.extent, 3 * trial.extent);
    const Box2 near = bounds.is_finite() && !bounds.is_empty() ? bounds.grown(0.2 * trial.extent) : around;
    trial.random_count = random_count;
    for (std::size_t i = 0; i < trial.random_count; ++i) {
        const Box2& box = i % 3 == 0 ? around : near;
        const double x = rng.in(box.lo.x(), box.hi.x());
        trial.points.emplace_back(x, rng.in(box.lo.y(), box.hi.y()));
    }
    sdf::Outline pieces;
    subject.collect_outline({}, pieces);
    add_special_points(subject, pieces, trial.extent, trial.points);
    for (std::size_t i = 0; i < pieces.size() && i < 12; ++i)
        for (const Vec2& p : points_along(pieces[i * pieces.size() / std::min<std::size_t>(12, pieces.size())], 5))
            trial.points.push_back(p);
    if (witness.parametric_outline) witness.parametric_outline(subject.params(), 40, trial.points);
    for (const Vec2& p : trial.points) trial.samples.push_back(subject.sample(p));
    measure_outline(trial);
    return trial;
}

void Trial::report(std::string what) const {
    std::size_t already = 0;
    for (const Violation& v : *violations) already += v.law == law;
    if (already < most_reported) violations->push_back({std::string(law), subject.text(), std::move(what)});
}

std::span<const Law> laws() { return all_laws; }

std::vector<Violation> check(const Subject& subject, const Witness& witness, std::uint64_t seed) {
    std::vector<Violation> out;
    Trial trial = trial_of(subject, witness, seed);
    trial.violations = &out;
    for (const Law& law : all_laws) {
        trial.law = law.name;
        law.check(trial);
    }
    return out;
}

}  // namespace pinfield::conformance
