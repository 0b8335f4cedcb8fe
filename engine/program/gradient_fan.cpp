#include "engine/program/gradient_fan.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/field.h"
#include "engine/program/tree.h"
#include "engine/sdf/outline_path.h"
#include "engine/sdf/piece.h"

namespace pinfield {
namespace {

using sdf::Form;
using sdf::Piece;

int child_of(const Field& field, const Op& op, int i) { return at(field.links, op.first_link + i); }

/// Directions of a fan times a length, mapped.
template <class Map>
void include_mapped(Fan& out, const Fan& fan, const Map& map) {
    if (fan.is_wide()) out.include(fan);
    if (fan.is_empty() || fan.is_wide()) return;
    out.include(map(fan.first()));
    out.include(map(fan.last()));
}

/// How much longer a linear map with these columns makes a vector at most: its greater singular value.
double greatest_stretch(const Vec2& x, const Vec2& y) {
    const double a = dot(x, x), b = dot(x, y), c = dot(y, y), apart = a - c;
    return std::sqrt(0.5 * (a + c + std::sqrt(apart * apart + 4 * b * b)));
}

constexpr double uneven = 1.2;  // a warp may stretch more beside the disc's axes than on them

/// Ways out of the solid that a piece may have seen from within the disc.
void include_normals(Fan& out, const Piece& piece, const Vec2& p, double radius) {
    if (!piece.is_arc()) return out.include(-perpendicular(Vec2(piece.b - piece.a)));
    const Vec2 from_centre = p - piece.centre;
    const double away = length(from_centre);
    if (away <= radius) {
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1)}) out.include(way);
        return;
    }
    const double sine = radius / away, cosine = std::sqrt(1 - sine * sine);
    const Vec2 middle = (piece.turn / away) * from_centre, aside = perpendicular(middle);
    for (const double side : {-sine, sine}) {
        const Vec2 way = cosine * middle + side * aside;
        if (in_sweep(piece, piece.turn * way)) out.include(way);
    }
    // Where its sweep ends before the disc does, the ends are as far as it goes; beyond it, the nearer end is what is seen.
    const bool beyond = !in_sweep(piece, from_centre);
    const Vec2& nearer = length(p - piece.a) < length(p - piece.b) ? piece.a : piece.b;
    for (const Vec2& end : {piece.a, piece.b}) {
        const Vec2 way = piece.turn * (end - piece.centre);
        if (dot(way, middle) > cosine * length(way) || (beyond && end == nearer)) out.include(way);
    }
}

}  // namespace

void Fan::check() {
    constexpr double nearly_opposite = -0.94;  // the cosine of 160 degrees
    if (cross(first_, last_) < 0 || dot(first_, last_) < nearly_opposite) state_ = State::wide;
}

void Fan::include(const Vec2& direction) {
    const double size = length(direction);
    if (!(size > 0) || state_ == State::wide) return;
    const Vec2 unit = direction / size;
    if (state_ == State::empty) {
        first_ = last_ = unit;
        state_ = State::narrow;
        return;
    }
    const bool before = cross(first_, unit) < 0, behind = cross(unit, last_) < 0;
    if (before) first_ = unit;
    if (behind) last_ = unit;
    if (before && behind) state_ = State::wide;
    // One that is opposite of a fan of one direction lies on neither side of it.
    if (dot(first_, unit) < 0 && dot(last_, unit) < 0) state_ = State::wide;
    check();
}

void Fan::include(const Fan& other) {
    if (other.is_empty()) return;
    if (other.is_wide()) {
        state_ = State::wide;
        return;
    }
    include(other.first_);
    include(other.last_);
}

const sdf::Outline& FanFinder::outline_of(int index) {
    const auto [found, is_new] = outlines_.try_emplace(index);
    if (!is_new) return found->second;
    const Op& op = at(field_.ops, index);
    const double* params = field_.params.data() + op.params;
    if (is_found_outline(op)) found->second = sdf::unpacked_outline(params);
    else if (op.kernels->outline) op.kernels->outline(params, found->second);
    return found->second;
}

/// Of a field that is known over boxes, all gradients of the square about the disc: a rectangle of them.
Fan FanFinder::fan_over_square(const Op& op, const Vec2& p, double radius) const {
    const Vec2 there = op.local_from_field * p, reach = Vec2(1, 1) * (radius / op.scale);
    const Box2 ways = op.kernels->over_box(field_.params.data() + op.params, {there - reach, there + reach}).gradients;
    if (!ways.is_finite() || ways.contains({0, 0})) return Fan::all();
    Fan out;
    for (const Vec2& way : {ways.lo, Vec2(ways.hi.x(), ways.lo.y()), ways.hi, Vec2(ways.lo.x(), ways.hi.y())})
        out.include(direction_before(op.local_from_field, way));
    return out;
}

/// Of an outline, all pieces may matter that can be the nearest somewhere in the disc. What has none is asked in the middle and round about.
FanFinder::Near FanFinder::near_shape(int index, const Vec2& p, double radius) {
    const Op& op = at(field_.ops, index);
    const sdf::Sample middle = evaluate_tree(field_, index, p);
    Near out{middle.value, op.exactness.lipschitz * radius, middle.gradient, {}};
    out.fan.include(middle.gradient);
    if (op.kernels->endless) return out;
    if (op.kernels->over_box) {
        out.fan = fan_over_square(op, p, radius);
        return out;
    }
    const sdf::Outline& outline = outline_of(index);
    if (outline.empty()) {
        constexpr double diagonal = 0.70710678118654752;
        for (const Vec2& way : {Vec2(diagonal, diagonal), Vec2(diagonal, -diagonal)})
            for (const double aside : {radius, -radius}) out.fan.include(evaluate_tree(field_, index, p + aside * way).gradient);
        return out;
    }
    Fan local;
    const Vec2 there = op.local_from_field * p;
    const double reach = radius / op.scale, limit = std::fabs(middle.value) / op.scale + 2 * reach;
    for (const Piece& piece : outline)
        if (!local.is_wide() && squared_distance_to_piece(piece, there) <= limit * limit) include_normals(local, piece, there, reach);
    include_mapped(out.fan, local, [&](const Vec2& way) { return direction_before(op.local_from_field, way); });
    return out;
}

/// A child matters where it moves the result for any values that the disc has.
FanFinder::Near FanFinder::near_fold(const Op& op, const Vec2& p, double radius) {
    constexpr double least_share = 1e-3;  // of a smooth fold: what moves it by less turns no field round
    const double* params = field_.params.data() + op.params;
    Near out = near(child_of(field_, op, 0), p, radius);
    for (int i = 1; i < op.child_count; ++i) {
        const Near next = near(child_of(field_, op, i), p, radius);
        Fan fan;
        for (const auto& [a, b] : {std::pair(0, 0), std::pair(-1, 1), std::pair(1, -1), std::pair(-1, -1), std::pair(1, 1)}) {
            const sdf::Partials f =
                op.kernels->combine_partials(params, (out.value + a * out.change) / op.scale, (next.value + b * next.change) / op.scale);
            if (std::fabs(f.by_a) > least_share) include_mapped(fan, out.fan, [&](const Vec2& way) { return Vec2(f.by_a * way); });
            if (std::fabs(f.by_b) > least_share) include_mapped(fan, next.fan, [&](const Vec2& way) { return Vec2(f.by_b * way); });
        }
        const sdf::Partials f = op.kernels->combine_partials(params, out.value / op.scale, next.value / op.scale);
        out = {f.value * op.scale, std::max(out.change, next.change), f.by_a * out.gradient + f.by_b * next.gradient, fan};
    }
    return out;
}

FanFinder::Near FanFinder::near_modify(const Op& op, const Vec2& p, double radius) {
    const double* params = field_.params.data() + op.params;
    const Near child = near(child_of(field_, op, 0), p, radius);
    const sdf::Affine affine = op.kernels->affine(params);
    const bool rises = affine.absolute ? child.value > -child.change : affine.sign > 0;
    const bool falls = affine.absolute ? child.value < child.change : affine.sign < 0;
    const bool flips = affine.absolute ? child.value < 0 : affine.sign < 0;
    Near out{op.kernels->modify(params, child.value / op.scale) * op.scale, child.change, flips ? Vec2(-child.gradient) : child.gradient, {}};
    if (rises) out.fan.include(child.fan);
    if (falls) include_mapped(out.fan, child.fan, [](const Vec2& way) { return Vec2(-way); });
    return out;
}

FanFinder::Near FanFinder::near_images(const Op& op, const Vec2& p, double radius) {
    const int child = child_of(field_, op, 0);
    const Op& below = at(field_.ops, child);
    std::vector<std::pair<int, Near>> seen;
    double least = infinity;
    for (int i = 0; i < op.image_count; ++i) {
        const Vec2 there = at(field_.images, op.first_image + i).inverse() * p;
        // An exact distance outside is at least that to its box.
        if (below.exactness.outside == Side::exact && below.bounds.distance(there) > std::max(least, 0.0) + 2 * radius) continue;
        seen.emplace_back(i, near(child, there, radius));
        least = std::min(least, seen.back().second.value);
    }
    Near out;
    out.value = infinity;
    for (const auto& [i, image] : seen) {
        if (image.value - image.change > least + image.change) continue;
        const Similarity& to = at(field_.images, op.first_image + i);
        include_mapped(out.fan, image.fan, [&](const Vec2& way) { return to.direction(way); });
        out.change = std::max(out.change, image.change);
        if (image.value < out.value) out.value = image.value, out.gradient = to.direction(image.gradient);
    }
    return out;
}

/// A child's gradient of the length it has in the middle, and the warp and its waves as they are along both axes of the disc. Where they
/// change by more from one place to the next than their slopes say, there is a fold or a wave between that was not seen.
FanFinder::Near FanFinder::near_warp(const Op& op, const Vec2& p, double radius) {
    const double* params = field_.params.data() + op.params;
    const double factor = op.kernels->factor(params), reach = radius / op.scale;
    const Similarity field_from_local = op.local_from_field.inverse();
    const Vec2 local = op.local_from_field * p;
    const sdf::Warped middle = op.kernels->warped(params, local);
    std::vector<sdf::Warped> seen{middle};
    const bool smooth = warps_smoothly(op, local, {reach, 0}, seen) && warps_smoothly(op, local, {0, reach}, seen);
    double stretch = 0;
    for (const sdf::Warped& here : seen) stretch = std::max(stretch, greatest_stretch(here.from_x, here.from_y));
    const Near child = near(child_of(field_, op, 0), field_from_local * middle.point, uneven * stretch * radius);
    const auto mapped = [&](const sdf::Warped& here, const Vec2& way) {
        return direction_before(op.local_from_field, here.gradient(factor, direction_before(field_from_local, way)));
    };
    Near out{factor * child.value + middle.lift * op.scale, op.exactness.lipschitz * radius, mapped(middle, child.gradient), {}};
    const double steepness = length(child.gradient);
    for (const sdf::Warped& here : seen)
        include_mapped(out.fan, child.fan, [&](const Vec2& way) { return mapped(here, steepness * way); });
    if (!smooth) out.fan = Fan::all();
    return out;
}

/// From the far end of `half` through the middle to its end, at places that no wave meets in step.
bool FanFinder::warps_smoothly(const Op& op, const Vec2& local, const Vec2& half, std::vector<sdf::Warped>& seen) const {
    constexpr std::array shares{-1.0, -0.72, -0.47, -0.21, 0.0, 0.24, 0.49, 0.75, 1.0};
    constexpr double most_unforeseen = 0.02;  // of the way between two places
    const double* params = field_.params.data() + op.params;
    const auto slope = [&](const sdf::Warped& here) { return half.x() != 0 ? here.from_x : here.from_y; };
    const Vec2 along = half / length(half);
    sdf::Warped before = op.kernels->warped(params, local + shares[0] * half);
    seen.push_back(before);
    for (std::size_t i = 1; i < shares.size(); ++i) {
        const sdf::Warped here = op.kernels->warped(params, local + shares[i] * half);
        const double way = (shares[i] - shares[i - 1]) * length(half);
        const Vec2 moved = here.point - before.point - 0.5 * way * (slope(here) + slope(before));
        const double lifted = here.lift - before.lift - 0.5 * way * dot(along, here.lift_gradient + before.lift_gradient);
        if (length(moved) > most_unforeseen * way || std::fabs(lifted) > most_unforeseen * way) return false;
        seen.push_back(here);
        before = here;
    }
    return true;
}

FanFinder::Near FanFinder::near(int index, const Vec2& p, double radius) {
    const Op& op = at(field_.ops, index);
    switch (op.kernels->form) {
        case Form::shape: return near_shape(index, p, radius);
        case Form::fold: return near_fold(op, p, radius);
        case Form::modify: return near_modify(op, p, radius);
        case Form::images: return near_images(op, p, radius);
        case Form::warp: return near_warp(op, p, radius);
    }
    assert(false && "an op has one of the five forms");
    return {};
}

}  // namespace pinfield
