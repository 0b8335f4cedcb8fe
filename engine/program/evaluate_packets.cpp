// Raw tree values at many points, in float packets. No allocation: every level of a tree keeps its rows on the stack.
#include <algorithm>
#include <array>
#include <xsimd/xsimd.hpp>

#include "engine/program/evaluate.h"

namespace pinfield {
namespace {

/// Points evaluated at once: a 32 x 32 tile. Small enough for a dozen rows of floats to stay in the first-level cache.
constexpr int block = 1024;
using Row = std::array<float, block>;
using Batch = xsimd::batch<float, xsimd::sse2>;
constexpr int width = static_cast<int>(Batch::size);
static_assert(block % width == 0);

struct Points {
    const float* x;
    const float* y;
    int n;  // at most block; rows may be written up to the next multiple of `width`
};

/// q = similarity * p for all points.
void transform(const Similarity& similarity, const Points& p, Row& qx, Row& qy) {
    const double mirror = similarity.mirrored ? -1 : 1, s = similarity.scale;
    const Batch xx(static_cast<float>(s * similarity.cosine)), xy(static_cast<float>(-s * similarity.sine * mirror));
    const Batch yx(static_cast<float>(s * similarity.sine)), yy(static_cast<float>(s * similarity.cosine * mirror));
    const Batch x0(static_cast<float>(similarity.offset.x())), y0(static_cast<float>(similarity.offset.y()));
    for (int i = 0; i < p.n; i += width) {
        const Batch x = Batch::load_unaligned(p.x + i), y = Batch::load_unaligned(p.y + i);
        (xx * x + xy * y + x0).store_unaligned(qx.data() + i);
        (yx * x + yy * y + y0).store_unaligned(qy.data() + i);
    }
}

void scale_row(float* row, int n, double factor) {
    if (factor == 1) return;
    const float f = static_cast<float>(factor);
    for (int i = 0; i < n; ++i) row[i] *= f;
}

class Evaluator {
public:
    Evaluator(const Field& field, sdf::Isa isa) : field_(field), isa_(static_cast<std::size_t>(isa)) {}

    void value(int op_index, const Points& p, Row& out) const {
        const Op& op = field_.ops[static_cast<std::size_t>(op_index)];
        switch (op.kernels->form) {
            case sdf::Form::shape: return shape(op, p, out);
            case sdf::Form::images: return images(op, p, out);
            case sdf::Form::warp: return warp(op, p, out);
            case sdf::Form::fold:
            case sdf::Form::modify: return combine(op, p, out);
        }
    }

private:
    const double* params(const Op& op) const { return field_.params.data() + op.params; }
    int child(const Op& op, int i) const { return field_.links[static_cast<std::size_t>(op.first_link + i)]; }
    /// A node that was not built for this instruction set (one of the user's own, say) has the baseline's kernels.
    sdf::PacketKernels packets(const Op& op) const {
        const sdf::PacketKernels& own = op.kernels->packets[isa_];
        return own.distance || own.combine || own.warp ? own : op.kernels->packets[static_cast<std::size_t>(sdf::Isa::sse2)];
    }

    void shape(const Op& op, const Points& p, Row& out) const {
        Row x, y;
        transform(op.local_from_field, p, x, y);
        packets(op).distance(params(op), x.data(), y.data(), out.data(), p.n);
        scale_row(out.data(), p.n, op.scale);
    }

    void combine(const Op& op, const Points& p, Row& out) const {
        const sdf::PacketCombine kernel = packets(op).combine;
        value(child(op, 0), p, out);
        scale_row(out.data(), p.n, 1 / op.scale);
        if (op.kernels->form == sdf::Form::modify) kernel(params(op), out.data(), out.data(), p.n);
        for (int i = 1; i < op.child_count; ++i) {
            Row next;
            value(child(op, i), p, next);
            scale_row(next.data(), p.n, 1 / op.scale);
            kernel(params(op), out.data(), next.data(), p.n);
        }
        scale_row(out.data(), p.n, op.scale);
    }

    void warp(const Op& op, const Points& p, Row& out) const {
        Row x, y, lift, there_x, there_y;
        transform(op.local_from_field, p, x, y);
        packets(op).warp(params(op), x.data(), y.data(), lift.data(), p.n);
        transform(op.local_from_field.inverse(), {x.data(), y.data(), p.n}, there_x, there_y);
        value(child(op, 0), {there_x.data(), there_y.data(), p.n}, out);
        const float factor = static_cast<float>(op.kernels->factor(params(op))), scale = static_cast<float>(op.scale);
        for (std::size_t i = 0; i < static_cast<std::size_t>(p.n); ++i) out[i] = factor * out[i] + scale * lift[i];
    }

    void images(const Op& op, const Points& p, Row& out) const {
        std::fill_n(out.begin(), p.n, std::numeric_limits<float>::infinity());
        for (int i = 0; i < op.image_count; ++i) {
            Row x, y, d;
            transform(field_.images[static_cast<std::size_t>(op.first_image + i)].inverse(), p, x, y);
            value(child(op, 0), {x.data(), y.data(), p.n}, d);
            std::transform(d.begin(), d.begin() + p.n, out.begin(), out.begin(),
                           [](float nearer, float so_far) { return nearer < so_far ? nearer : so_far; });
        }
    }

    const Field& field_;
    std::size_t isa_;
};

/// distance = min(distance, d) and, where d is less, winner = index; indices up to 2^24 are exact as floats.
void take_minimum(const Row& d, int index, int n, Row& distance, Row& winner) {
    const Batch number(static_cast<float>(index));
    for (int i = 0; i < n; i += width) {
        const Batch a = Batch::load_unaligned(distance.data() + i), b = Batch::load_unaligned(d.data() + i);
        const auto nearer = b < a;
        xsimd::select(nearer, b, a).store_unaligned(distance.data() + i);
        xsimd::select(nearer, number, Batch::load_unaligned(winner.data() + i)).store_unaligned(winner.data() + i);
    }
}

void take_minimum(const Row& d, int n, Row& distance) {
    for (int i = 0; i < n; i += width)
        xsimd::min(Batch::load_unaligned(distance.data() + i), Batch::load_unaligned(d.data() + i))
            .store_unaligned(distance.data() + i);
}

}  // namespace

void evaluate_packets(const Field& field, std::span<const int> candidates, const float* x, const float* y, int n,
                      float* distance, int* solid, sdf::Isa isa) {
    const Evaluator evaluator(field, isa);
    Row px, py, best, winner, d;
    for (int start = 0; start < n; start += block) {
        const int count = std::min(block, n - start);
        const int whole = (count + width - 1) / width * width;
        std::copy_n(x + start, count, px.begin());
        std::copy_n(y + start, count, py.begin());
        std::fill(px.begin() + count, px.begin() + whole,
                  0.0f);  // whole batches are read: these must at least be numbers
        std::fill(py.begin() + count, py.begin() + whole, 0.0f);
        std::fill_n(best.begin(), whole, std::numeric_limits<float>::infinity());
        std::fill_n(winner.begin(), whole, -1.0f);
        for (const int candidate : candidates) {
            evaluator.value(field.solids[static_cast<std::size_t>(candidate)].root, {px.data(), py.data(), count}, d);
            if (solid)
                take_minimum(d, candidate, count, best, winner);
            else
                take_minimum(d, count, best);
        }
        std::copy_n(best.begin(), count, distance + start);
        if (solid)
            for (int i = 0; i < count; ++i) solid[start + i] = static_cast<int>(winner[static_cast<std::size_t>(i)]);
    }
}

}  // namespace pinfield
