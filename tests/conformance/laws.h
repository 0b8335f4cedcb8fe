// The laws every shape and operation obeys. A law is one function from a subject to the list of its violations, so that a
// test can demand both: none from the engine's nodes, and some from each planted fault.
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/conformance/check.h"
#include "tests/conformance/subject.h"

namespace pinfield::conformance {

/// What the outline's own definition says at each point of a trial; see brute_force.h.
struct OutlineTruth {
    std::vector<double> distance;  ///< metres, unsigned; empty where the node gives no outline
    std::vector<bool> inside;      ///< of shapes only
    double error = 0;              ///< metres, of the distances
    Box2 box;                      ///< around the outline; of shapes only
};

/// A law's working place: the subject, what it says at the points it is tried at, and where violations go. The points: first
/// random ones in and around the solid, then those where formulas branch (origin, axes, diagonals, corners and centres of the
/// outline, bounds), then the outline's own.
struct Trial {
    const Subject& subject;
    const Witness& witness;  ///< of the subject's type
    double extent;  ///< metres
    Exactness exactness;
    std::size_t random_count = 0;
    std::vector<Vec2> points{};
    std::vector<sdf::Sample> samples{};
    OutlineTruth truth{};
    std::vector<Violation>* violations = nullptr;
    std::string_view law{};

    void report(std::string what) const;
    /// Rounding that any sum of products of the size of p may carry.
    double rounding(const Vec2& p) const { return 1e-13 * std::max(extent, length(p)); }
};

/// A subject at `random_count` random points and all the special ones, with its truth.
Trial trial_of(const Subject& subject, const Witness& witness, std::uint64_t seed, std::size_t random_count = 50);
/// Fills in a trial's truth.
void measure_outline(Trial& trial);

struct Law {
    std::string_view name;
    void (*check)(const Trial& trial);
};
/// All of them, in the order a person would want to read their complaints.
std::span<const Law> laws();

/// Violations of all laws, at most a few of each; `seed` draws the points.
std::vector<Violation> check(const Subject& subject, const Witness& witness, std::uint64_t seed);

// The laws, by what they look at.
void everything_is_finite(const Trial& trial);
void value_alone_is_value_with_gradient(const Trial& trial);
void gradient_is_unit_where_exact(const Trial& trial);
void gradient_is_the_central_difference(const Trial& trial);
void gradient_is_within_lipschitz(const Trial& trial);
void field_is_lipschitz(const Trial& trial);
void field_is_not_zero_on_an_area(const Trial& trial);
void safe_disc_holds_no_surface(const Trial& trial);

void bounds_contain_the_solid(const Trial& trial);
void bounds_of_a_shape_are_tight(const Trial& trial);
void exact_sides_are_brute_force_distances(const Trial& trial);
void no_side_overestimates(const Trial& trial);
void sign_tells_inside_from_outside(const Trial& trial);
void solid_is_on_the_left_of_its_outline(const Trial& trial);
void gradient_on_the_outline_points_out(const Trial& trial);
void foot_point_is_on_the_outline_where_exact(const Trial& trial);

void size_is_a_matter_of_scale(const Trial& trial);
void order_of_children_is_no_matter(const Trial& trial);
void order_of_points_is_no_matter(const Trial& trial);

void packets_are_the_value_within_float_error(const Trial& trial);
void every_instruction_set_gives_the_same_bits(const Trial& trial);
void warp_packets_are_the_warp(const Trial& trial);
void fold_strays_no_further_than_its_slack(const Trial& trial);
void fold_partials_are_weights_of_differences(const Trial& trial);
void modify_is_what_its_affine_form_says(const Trial& trial);
void exactness_at_defaults_is_as_described(const Trial& trial);

void enclosures_hold_the_samples(const Trial& trial);
void enclosures_do_not_refute_the_lipschitz_constant(const Trial& trial);

}  // namespace pinfield::conformance
