// Packet kernels of one node for one instruction set. Included by the translation units that are compiled for that set:
// every function here is a template over the packet type, so no symbol can be shared with code for another machine.
#pragma once
#include "engine/reflect/load.h"
#include "engine/sdf/kernels.h"
#include "engine/sdf/node_list.h"
#include "engine/sdf/outline_distance.h"
#include "engine/sdf/packet.h"

namespace pinfield::sdf {

/// A shape with no distance of its own is written as its outline of at most `most_pieces` lines and arcs, whose packed form
/// follows its fields and derived values in its block.
template <class T>
concept HasOutlineOnly = requires { T::most_pieces; };

template <class T, class Real>
Real shape_distance(const T& node, const double* params, const Point<Real>& p) {
    if constexpr (HasOutlineOnly<T>) return distance_to_outline(p, params + packed_size<T>());
    else return node.distance(p);
}

/// Packets that a shape takes at once, where that spares it work.
inline constexpr int packet_group = 8;

template <class T, class P>
concept TakesGroups = requires(const T& node, const Point<P> (&p)[packet_group], P (&out)[packet_group]) { node.distances(p, out); };

/// A PacketFrame in packets: by value, as the compiler must fear that storing distances changes floats it knows by reference.
template <class P>
struct LocalFrame {
    P xx, xy, x0, yx, yy, y0, scale;

    explicit LocalFrame(const PacketFrame& f)
        : xx(f.xx), xy(f.xy), x0(f.x0), yx(f.yx), yy(f.yy), y0(f.y0), scale(f.scale) {}
    Point<P> point(const float* x, const float* y) const {
        const P px = P::load(x), py = P::load(y);
        return {xx * px + xy * py + x0, yx * px + yy * py + y0};
    }
};

template <class T, class P>
void packet_distance(const double* params, const PacketFrame& frame, const float* x, const float* y, float* distance, int n) {
    const T node = load<T>(params);
    const LocalFrame<P> local(frame);
    int i = 0;
    if constexpr (TakesGroups<T, P>) {
        for (; i + packet_group * P::width <= n; i += packet_group * P::width) {
            Point<P> p[packet_group];
            P d[packet_group];
            for (int k = 0; k < packet_group; ++k) p[k] = local.point(x + i + k * P::width, y + i + k * P::width);
            node.distances(p, d);
            for (int k = 0; k < packet_group; ++k) (local.scale * d[k]).store(distance + i + k * P::width);
        }
    }
    const auto one = [&](const float* at_x, const float* at_y, float* to) {
        (local.scale * shape_distance<T, P>(node, params, local.point(at_x, at_y))).store(to);
    };
    for (; i + P::width <= n; i += P::width) one(x + i, y + i, distance + i);
    if (i == n) return;
    float tail_x[P::width] = {}, tail_y[P::width] = {}, tail[P::width];
    for (int j = 0; i + j < n; ++j) tail_x[j] = x[i + j], tail_y[j] = y[i + j];
    one(tail_x, tail_y, tail);
    for (int j = 0; i + j < n; ++j) distance[i + j] = tail[j];
}

template <class T, class P>
P packet_combined(const T& node, const P& a, const P& b) {
    if constexpr (requires { node.combine(a, b); }) return node.combine(a, b);
    else return node.modify(a);
}

template <class T, class P>
void packet_combine(const double* params, float* a, const float* b, int n) {
    const T node = load<T>(params);
    int i = 0;
    for (; i + P::width <= n; i += P::width) packet_combined(node, P::load(a + i), P::load(b + i)).store(a + i);
    if (i == n) return;
    float tail_a[P::width] = {}, tail_b[P::width] = {};
    for (int j = 0; i + j < n; ++j) tail_a[j] = a[i + j], tail_b[j] = b[i + j];
    packet_combined(node, P::load(tail_a), P::load(tail_b)).store(tail_a);
    for (int j = 0; i + j < n; ++j) a[i + j] = tail_a[j];
}

template <class T, class P>
P lift_of(const T& node, const Point<P>& p) {
    if constexpr (requires { node.lift(p); }) return node.lift(p);
    else return P(0);
}

template <class T, class P>
void packet_warp(const double* params, float* x, float* y, float* lift, int n) {
    const T node = load<T>(params);
    for (int i = 0; i < n; i += P::width) {
        float in_x[P::width] = {}, in_y[P::width] = {}, out[P::width];
        const int lanes = n - i < P::width ? n - i : P::width;
        for (int j = 0; j < lanes; ++j) in_x[j] = x[i + j], in_y[j] = y[i + j];
        const Point<P> p{P::load(in_x), P::load(in_y)}, q = node.warp(p);
        lift_of<T, P>(node, p).store(out);
        q.x.store(in_x);
        q.y.store(in_y);
        for (int j = 0; j < lanes; ++j) x[i + j] = in_x[j], y[i + j] = in_y[j], lift[i + j] = out[j];
    }
}

template <template <class> class N, class P>
PacketKernels packet_kernels() {
    using T = N<P>;
    PacketKernels k;
    if constexpr (HasOutlineOnly<T> || requires(const T& node, const Point<P>& p) { node.distance(p); })
        k.distance = packet_distance<T, P>;
    else if constexpr (requires(const T& node, const P& d) { node.combine(d, d); } ||
                       requires(const T& node, const P& d) { node.modify(d); })
        k.combine = packet_combine<T, P>;
    else if constexpr (requires(const T& node, const Point<P>& p) { node.warp(p); }) k.warp = packet_warp<T, P>;
    return k;
}

/// Those of a whole list, in its order.
template <class P, template <class> class... N>
void fill_packets(NodeList<N...>, PacketKernels* out) {
    ((*out++ = packet_kernels<N, P>()), ...);
}

}  // namespace pinfield::sdf
