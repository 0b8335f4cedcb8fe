#include "tests/conformance/packets.h"

#include <cmath>

#include "engine/core/at.h"
#include "engine/core/rng.h"

namespace pinfield::conformance {

Operands operands(double extent) {
    Operands out;
    CounterRng rng(11);
    for (int i = 0; i < 200; ++i) {
        const double a = extent * rng.in(-1, 1), b = i % 5 == 0 ? a : i % 7 == 0 ? -a : extent * rng.in(-1, 1);
        out.a.push_back(i % 11 == 0 ? 0 : a);
        out.b.push_back(b);
    }
    return out;
}

Floats points_in_floats(const Trial& trial) {
    Floats out;
    for (const Vec2& p : trial.points) {
        out.a.push_back(static_cast<float>(p.x()));
        out.b.push_back(static_cast<float>(p.y()));
    }
    return out;
}

Floats packet_input(const Trial& trial) {
    Floats out;
    if (trial.subject.is_shape()) return points_in_floats(trial);
    const Operands pairs = operands(trial.extent);
    out.a.assign(pairs.a.begin(), pairs.a.end());
    out.b.assign(pairs.b.begin(), pairs.b.end());
    return out;
}

std::vector<float> run(const Subject& subject, sdf::Isa isa, const std::vector<float>& a, const std::vector<float>& b) {
    if (isa > sdf::best_isa()) return {};
    const sdf::PacketKernels& k = at(subject.kernels().packets, isa);
    std::vector<float> out = a;
    const int n = static_cast<int>(a.size());
    if (k.distance) k.distance(subject.params(), {}, a.data(), b.data(), out.data(), n);
    else if (k.combine) k.combine(subject.params(), out.data(), b.data(), n);
    else return {};
    return out;
}

double in_double(const Subject& subject, double a, double b) {
    const sdf::Kernels& k = subject.kernels();
    switch (k.form) {
        case sdf::Form::shape: return k.distance(subject.params(), a, b);
        case sdf::Form::fold: return k.combine(subject.params(), a, b);
        default: return k.modify(subject.params(), a);
    }
}

Floats3 warp(const Subject& subject, sdf::Isa isa, const Floats& points) {
    const sdf::PacketKernels& k = at(subject.kernels().packets, isa);
    if (isa > sdf::best_isa() || !k.warp) return {};
    Floats3 out{points.a, points.b, std::vector<float>(points.a.size())};
    k.warp(subject.params(), out.x.data(), out.y.data(), out.lift.data(), static_cast<int>(out.x.size()));
    return out;
}

double missed_by(const Subject& subject, const Vec2& sent, const Vec2& p) {
    const sdf::Kernels& k = subject.kernels();
    Vec2 miss = sent - k.warp(subject.params(), p);
    const Vec2 step = k.lattice ? k.lattice(subject.params()).step : Vec2(0, 0);
    for (const int axis : {0, 1})
        if (step[axis] > 0) miss[axis] = std::remainder(miss[axis], step[axis]);
    return k.factor(subject.params()) * length(miss);
}

}  // namespace pinfield::conformance
