// Distances of solids at many points, in float packets. No allocation: every level of a tree keeps its rows on the stack.
#include <algorithm>
#include <array>
#include <xsimd/xsimd.hpp>

#include "engine/core/at.h"
#include "engine/program/evaluate.h"
#include "engine/program/field.h"
#include "engine/sdf/register.h"

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
    int n;  // at most block; rows are read and written up to the next multiple of `width`
};

sdf::PacketFrame frame_of(const Similarity& similarity, double scale) {
    const double mirror = similarity.mirrored ? -1 : 1, s = similarity.scale;
    sdf::PacketFrame f;
    f.xx = static_cast<float>(s * similarity.cosine);
    f.xy = static_cast<float>(-s * similarity.sine * mirror);
    f.x0 = static_cast<float>(similarity.offset.x());
    f.yx = static_cast<float>(s * similarity.sine);
    f.yy = static_cast<float>(s * similarity.cosine * mirror);
    f.y0 = static_cast<float>(similarity.offset.y());
    f.scale = static_cast<float>(scale);
    return f;
}

/// q = similarity * p for all points.
void transform(const Similarity& similarity, const Points& p, Row& qx, Row& qy) {
    const sdf::PacketFrame f = frame_of(similarity, 1);
    const Batch xx(f.xx), xy(f.xy), yx(f.yx), yy(f.yy), x0(f.x0), y0(f.y0);
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

    void value(const PacketSolid& candidate, const Points& p, float* out) const {
        const int root = at(field_.solids, candidate.solid).root;
        if (!candidate.outline) return value(root, p, out);
        packets(sdf::found_outline_kernels()).distance(candidate.outline, sdf::PacketFrame{}, p.x, p.y, out, p.n);
        take_side(root, p, out);
    }

    void value(int op_index, const Points& p, float* out) const {
        const Op& op = at(field_.ops, op_index);
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
    int child(const Op& op, int i) const { return at(field_.links, op.first_link + i); }
    /// A node that was not built for this instruction set (one of the user's own, say) has the baseline's kernels.
    sdf::PacketKernels packets(const sdf::Kernels& kernels) const {
        const sdf::PacketKernels& own = kernels.packets[isa_];
        return own.distance || own.combine || own.warp ? own : at(kernels.packets, sdf::Isa::sse2);
    }

    void shape(const Op& op, const Points& p, float* out) const {
        packets(*op.kernels).distance(params(op), frame_of(op.local_from_field, op.scale), p.x, p.y, out, p.n);
        if (is_found_outline(op)) take_side(child(op, 0), p, out);
    }

    /// A boundary may have pieces shorter than a float's rounding, which have no direction in floats: the tree's formula decides the side.
    void take_side(int tree, const Points& p, float* out) const {
        Row side;
        value(tree, p, side.data());
        for (int i = 0; i < p.n; ++i) out[i] = std::copysign(out[i], at(side, i));
    }

    void combine(const Op& op, const Points& p, float* out) const {
        const sdf::PacketCombine kernel = packets(*op.kernels).combine;
        value(child(op, 0), p, out);
        scale_row(out, p.n, 1 / op.scale);
        if (op.kernels->form == sdf::Form::modify) kernel(params(op), out, out, p.n);
        for (int i = 1; i < op.child_count; ++i) {
            Row next;
            value(child(op, i), p, next.data());
            scale_row(next.data(), p.n, 1 / op.scale);
            kernel(params(op), out, next.data(), p.n);
        }
        scale_row(out, p.n, op.scale);
    }

    void warp(const Op& op, const Points& p, float* out) const {
        Row x, y, lift, there_x, there_y;
        transform(op.local_from_field, p, x, y);
        packets(*op.kernels).warp(params(op), x.data(), y.data(), lift.data(), p.n);
        transform(op.local_from_field.inverse(), {x.data(), y.data(), p.n}, there_x, there_y);
        value(child(op, 0), {there_x.data(), there_y.data(), p.n}, out);
        const float factor = static_cast<float>(op.kernels->factor(params(op))), scale = static_cast<float>(op.scale);
        for (int i = 0; i < p.n; ++i) out[i] = factor * out[i] + scale * at(lift, i);
    }

    void images(const Op& op, const Points& p, float* out) const {
        std::fill_n(out, p.n, std::numeric_limits<float>::infinity());
        for (int i = 0; i < op.image_count; ++i) {
            Row x, y, d;
            transform(at(field_.images, op.first_image + i).inverse(), p, x, y);
            value(child(op, 0), {x.data(), y.data(), p.n}, d.data());
            std::transform(d.begin(), d.begin() + p.n, out, out,
                           [](float nearer, float so_far) { return nearer < so_far ? nearer : so_far; });
        }
    }

    const Field& field_;
    std::size_t isa_;
};

/// distance = min(distance, d) and, where d is less, winner = index.
void take_minimum(const float* d, int index, int n, float* distance, int* winner) {
    for (int i = 0; i < n; ++i) {
        const bool nearer = d[i] < distance[i];
        distance[i] = nearer ? d[i] : distance[i];
        winner[i] = nearer ? index : winner[i];
    }
}

void take_minimum(const float* d, int n, float* distance) {
    for (int i = 0; i < n; i += width)
        xsimd::min(Batch::load_unaligned(distance + i), Batch::load_unaligned(d + i)).store_unaligned(distance + i);
}

/// As many points as there are, at most `block`, in rows that may be read in whole batches.
class PaddedPoints {
public:
    PaddedPoints(const float* x, const float* y, int n) : points_{x, y, n} {
        if (n % width == 0) return;
        x_.fill(0);  // what is read must at least be numbers
        y_.fill(0);
        std::copy_n(x, n, x_.begin());
        std::copy_n(y, n, y_.begin());
        points_ = {x_.data(), y_.data(), n};
    }
    PaddedPoints(const PaddedPoints&) = delete;
    PaddedPoints& operator=(const PaddedPoints&) = delete;
    const Points& get() const { return points_; }

private:
    Points points_;
    Row x_, y_;
};

}  // namespace

void evaluate_packets(const Field& field, std::span<const PacketSolid> candidates, const float* x, const float* y, int n,
                      float* distance, int* solid, sdf::Isa isa) {
    const Evaluator evaluator(field, isa);
    Row padded, d;
    for (int start = 0; start < n; start += block) {
        const int count = std::min(block, n - start);
        const PaddedPoints points(x + start, y + start, count);
        const bool is_whole = count % width == 0;  // else the last batch would be written beyond the caller's end
        float* best = is_whole ? distance + start : padded.data();
        if (candidates.empty()) std::fill_n(best, count, std::numeric_limits<float>::infinity());
        else evaluator.value(candidates[0], points.get(), best);
        if (solid) std::fill_n(solid + start, count, candidates.empty() ? -1 : candidates[0].solid);
        for (std::size_t k = 1; k < candidates.size(); ++k) {
            evaluator.value(candidates[k], points.get(), d.data());
            if (solid)
                take_minimum(d.data(), candidates[k].solid, count, best, solid + start);
            else
                take_minimum(d.data(), count, best);
        }
        if (!is_whole) std::copy_n(best, count, distance + start);
    }
}

}  // namespace pinfield
