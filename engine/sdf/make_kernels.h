// From a node's struct template to its Kernels. What a node may provide, and what each thing is for, is in kernels.h;
// engine/sdf/nodes/circle.h and engine/sdf/operations/union.h are the patterns to follow.
#pragma once
#include <concepts>

#include "engine/core/at.h"
#include "engine/reflect/erase.h"
#include "engine/reflect/load.h"
#include "engine/sdf/dual.h"
#include "engine/sdf/interval_dual.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/node_list.h"
#include "engine/sdf/outline_path.h"
#include "engine/sdf/packet_kernels.h"

namespace pinfield::sdf {

template <class T>
concept IsShape = HasOutlineOnly<T> || requires(const T& node, const Point<double>& p) { { node.distance(p) } -> std::same_as<double>; };
template <class T>
concept IsFold = requires(const T& node, double d) { { node.combine(d, d) } -> std::same_as<double>; };
template <class T>
concept IsModify = requires(const T& node, double d) { { node.modify(d) } -> std::same_as<double>; };
template <class T>
concept IsImages = requires(const T& node) { { node.images() } -> std::same_as<std::vector<Similarity>>; };
template <class T>
concept IsWarp = requires(const T& node, const Point<double>& p) { { node.warp(p) } -> std::same_as<Point<double>>; };
/// A fold that is not itself made of min, max and minus names the counterpart that is, and how far it strays from it.
template <class T>
concept HasHard = requires(const T& node, double d) { { node.hard(d, d) } -> std::same_as<double>; };

namespace detail {

template <class T>
Exactness shape_exactness(const double* params, std::span<const Exactness>) {
    if constexpr (requires(const T& node) { { node.exactness() } -> std::same_as<Exactness>; })
        return load<T>(params).exactness();
    else return T::describe().meta.exactness;
}

template <template <class> class N>
void fill_shape(Kernels& k) {
    using T = N<double>;
    k.form = Form::shape;
    k.exactness = shape_exactness<T>;
    k.distance = [](const double* params, double x, double y) {
        return shape_distance<T, double>(load<T>(params), params, {x, y});
    };
    k.sample = [](const double* params, double x, double y) -> Sample {
        const Dual d = shape_distance<N<Dual>, Dual>(load<N<Dual>>(params), params, {Dual(x, 1, 0), Dual(y, 0, 1)});
        return {d.v, {d.dx, d.dy}};
    };
    k.bounds = [](const double* params) {
        if constexpr (requires(const T& node) { node.bounds(); }) {
            return load<T>(params).bounds();
        } else {
            Outline out;
            load<T>(params).outline(out);
            return bounds_of(out);
        }
    };
    if constexpr (HasOutlineOnly<T>) {
        k.derived_count += packed_outline_size(T::most_pieces);
        k.derive = [](double* params) {
            derive_in_place<T>(params);
            Outline out;
            load<T>(params).outline(out);
            pack_outline(out, T::most_pieces, params + packed_size<T>());
        };
    }
    if constexpr (requires { { T::known_over_boxes } -> std::convertible_to<bool>; })
        k.over_box = [](const double* params, const Box2& box) {
            const Interval x(box.lo.x(), box.hi.x()), y(box.lo.y(), box.hi.y()), one(1), none(0);
            const IntervalDual d = load<N<IntervalDual>>(params).distance({{x, one, none}, {y, none, one}});
            return FieldOverBox{d.v.lo, d.v.hi, {{d.dx.lo, d.dy.lo}, {d.dx.hi, d.dy.hi}}};
        };
    if constexpr (requires(const T& node) { { node.bounds_below(1.0) } -> std::same_as<Box2>; })
        k.bounds_below = [](const double* params, double below) { return load<T>(params).bounds_below(below); };
    if constexpr (requires(const T& node, std::string_view text) { node.refusal(text); })
        k.refusal = [](const double* params, std::string_view text) { return load<T>(params).refusal(text); };
    if constexpr (requires(const T& node, Outline& out) { node.outline(out); })
        k.outline = [](const double* params, Outline& out) { load<T>(params).outline(out); };
    if constexpr (requires { { T::convex } -> std::convertible_to<bool>; }) k.convex = T::convex;
    if constexpr (requires { { T::endless } -> std::convertible_to<bool>; }) k.endless = T::endless;
}

template <template <class> class N>
void fill_fold(Kernels& k) {
    using T = N<double>;
    k.form = Form::fold;
    k.combine = [](const double* params, double a, double b) { return load<T>(params).combine(a, b); };
    k.combine_partials = [](const double* params, double a, double b) -> Partials {
        const Dual d = load<N<Dual>>(params).combine(Dual(a, 1, 0), Dual(b, 0, 1));
        return {d.v, d.dx, d.dy};
    };
    if constexpr (HasHard<T>) {
        k.combine_hard = [](const double* params, double a, double b) { return load<T>(params).hard(a, b); };
        k.combine_clearance = [](const double*, const Clearance& a, const Clearance& b) {
            return N<Clearance>::hard(a, b);
        };
        k.slack = [](const double* params) { return load<T>(params).slack(); };
    } else {
        k.combine_hard = k.combine;
        k.combine_clearance = [](const double*, const Clearance& a, const Clearance& b) {
            return N<Clearance>{}.combine(a, b);
        };
        k.slack = [](const double*) { return Slack{}; };
    }
}

template <template <class> class N>
void fill_modify(Kernels& k) {
    using T = N<double>;
    k.form = Form::modify;
    k.modify = [](const double* params, double d) { return load<T>(params).modify(d); };
    k.affine = [](const double* params) { return load<T>(params).affine(); };
}

template <template <class> class N>
void fill_warp(Kernels& k) {
    using T = N<double>;
    k.form = Form::warp;
    k.warp = [](const double* params, const Vec2& p) {
        const Point<double> q = load<T>(params).warp({p.x(), p.y()});
        return Vec2(q.x, q.y);
    };
    k.lift = [](const double* params, const Vec2& p) {
        return lift_of<T, double>(load<T>(params), Point<double>{p.x(), p.y()});
    };
    k.warped = [](const double* params, const Vec2& p) -> Warped {
        const auto node = load<N<Dual>>(params);
        const Point<Dual> at{Dual(p.x(), 1, 0), Dual(p.y(), 0, 1)}, q = node.warp(at);
        const Dual lift = lift_of<N<Dual>, Dual>(node, at);
        return {{q.x.v, q.y.v}, {q.x.dx, q.y.dx}, {q.x.dy, q.y.dy}, lift.v, {lift.dx, lift.dy}};
    };
    k.factor = [](const double* params) {
        if constexpr (requires(const T& node) { node.factor(); }) return load<T>(params).factor();
        else return 1.0;
    };
    if constexpr (requires(const T& node) { { node.lattice() } -> std::same_as<Lattice>; })
        k.lattice = [](const double* params) { return load<T>(params).lattice(); };
}

}  // namespace detail

/// The dispatch table of node template N, with the packet kernels of the baseline instruction set alone.
template <template <class> class N>
Kernels make_kernels() {
    using T = N<double>;
    Kernels k;
    k.derived_count = derived_count<T>();
    k.derive = derive_in_place<T>;
    if constexpr (IsShape<T>) {
        detail::fill_shape<N>(k);
    } else {
        k.exactness = [](const double* params, std::span<const Exactness> children) {
            return load<T>(params).exactness(children);
        };
        if constexpr (IsImages<T>) {
            k.form = Form::images;
            k.images = [](const double* params) { return load<T>(params).images(); };
        } else {
            k.bounds_over = [](const double* params, std::span<const Box2> children) {
                return load<T>(params).bounds(children);
            };
            if constexpr (requires(const T& node) { { node.reach(1) } -> std::same_as<double>; })
                k.reach = [](const double* params, int children) { return load<T>(params).reach(children); };
            if constexpr (IsFold<T>) detail::fill_fold<N>(k);
            else if constexpr (IsWarp<T>) detail::fill_warp<N>(k);
            else {
                static_assert(IsModify<T>, "an operation has combine(), modify(), images() or warp()");
                detail::fill_modify<N>(k);
            }
        }
    }
    at(k.packets, Isa::sse2) = packet_kernels<N, Packet<xsimd::sse2>>();
    return k;
}

/// What AddFamily of catalog.h asks for.
template <template <class> class... N>
void add_nodes(NodeList<N...>, std::vector<NodeType>& types, std::vector<Kernels>& kernels) {
    (types.push_back(node_type<N<double>>()), ...);
    (kernels.push_back(make_kernels<N>()), ...);
}

}  // namespace pinfield::sdf
