#include "tests/conformance/subject.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/numbers.h"
#include "engine/reflect/text_fault.h"

namespace pinfield::conformance {
namespace {

std::string text_of(const Value& value) {
    if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
    if (const auto* i = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *i);
    if (const auto* d = std::get_if<double>(&value)) return fmt::format("{}", *d);
    if (const auto* v = std::get_if<Vec2>(&value)) return fmt::format("[{}, {}]", v->x(), v->y());
    if (const auto* s = std::get_if<std::string>(&value)) return *s;
    if (const auto* list = std::get_if<std::vector<Vec2>>(&value)) {
        std::string out = "[";
        for (const Vec2& v : *list) out += fmt::format("[{}, {}] ", v.x(), v.y());
        return out + "]";
    }
    return fmt::format("[{}]", fmt::join(std::get<std::vector<std::string>>(value), ", "));
}

}  // namespace

Subject::Subject(const NodeType& type, std::vector<Value> values, std::vector<Subject> children,
                 const Similarity& parent_from_local)
    : type_(&type), values_(std::move(values)), children_(std::move(children)), parent_from_local_(parent_from_local) {
    params_ = pack(type, values_, kernels().derived_count);
    params_.push_back(0);  // a node without fields has a block to point at, too
    kernels().derive(params_.data());
}

bool Subject::accepted(const NodeType& type, const std::vector<Value>& values) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(type.own_fields); ++i)
        if (why_invalid(type.fields[i], values[i])) return false;
    const std::vector<double> block = pack(type, values, type.kernels->derived_count);
    if (broken_contract(type, block.data())) return false;
    return !type.kernels->refusal || !type.kernels->refusal(block.data(), {});
}

std::string Subject::text() const {
    std::string out = fmt::format("{} {{", type_->key());
    for (std::size_t i = 0; i < static_cast<std::size_t>(type_->own_fields); ++i)
        out += fmt::format("{}{}: {}", i == 0 ? "" : ", ", type_->fields[i].key, text_of(values_[i]));
    out += "}";
    for (const Subject& child : children_) out += fmt::format(" / {}", child.text());
    return out;
}

sdf::Sample Subject::sample(const Vec2& p) const {
    sdf::Sample s = local_sample(parent_from_local_.inverse() * p);
    s.value *= parent_from_local_.scale;
    s.gradient = parent_from_local_.direction(s.gradient);
    return s;
}

sdf::Sample Subject::local_sample(const Vec2& p) const {
    const sdf::Kernels& k = kernels();
    if (k.form == sdf::Form::shape) return k.sample(params(), p.x(), p.y());
    if (k.form == sdf::Form::images) {
        sdf::Sample best{infinity, {0, 0}};
        for (const Similarity& local_from_image : k.images(params())) {
            const sdf::Sample s = children_[0].sample(local_from_image.inverse() * p);
            if (s.value < best.value) best = {s.value, local_from_image.direction(s.gradient)};
        }
        return best;
    }
    if (k.form == sdf::Form::warp) {
        const sdf::Warped warped = k.warped(params(), p);
        const sdf::Sample s = nearest_of_neighbours(warped.point);
        return {k.factor(params()) * s.value + warped.lift, warped.gradient(k.factor(params()), s.gradient)};
    }
    sdf::Sample sum = children_[0].sample(p);
    if (k.form == sdf::Form::modify) {
        const sdf::Affine affine = k.affine(params());
        const double slope = affine.absolute ? (sum.value < 0 ? -1.0 : 1.0) : affine.sign;
        return {k.modify(params(), sum.value), slope * sum.gradient};
    }
    for (std::size_t i = 1; i < children_.size(); ++i) {
        const sdf::Sample next = children_[i].sample(p);
        const sdf::Partials f = k.combine_partials(params(), sum.value, next.value);
        sum = {f.value, f.by_a * sum.gradient + f.by_b * next.gradient};
    }
    return sum;
}

std::vector<Vec2> Subject::neighbour_offsets() const {
    const sdf::Lattice lattice = kernels().lattice(params());
    const auto [columns, rows] = lattice.neighbours(children_[0].bounds());
    std::vector<Vec2> out;
    for (int row = -rows; row <= rows; ++row)
        for (int column = -columns; column <= columns; ++column) out.push_back(lattice.step.cwiseProduct(Vec2(column, row)));
    return out;
}

/// Of a warp's child and, where it folds into a lattice, of its copies nearby.
sdf::Sample Subject::nearest_of_neighbours(const Vec2& p) const {
    if (!kernels().lattice) return children_[0].sample(p);
    sdf::Sample best{infinity, {0, 0}};
    for (const Vec2& offset : neighbour_offsets()) {
        const sdf::Sample s = children_[0].sample(p - offset);
        if (s.value < best.value) best = s;
    }
    return best;
}

Exactness Subject::exactness() const {
    std::vector<Exactness> below;
    for (const Subject& child : children_) below.push_back(child.exactness());
    return kernels().exactness(params(), below);
}

Box2 Subject::bounds_of_isoline(double level) const {
    const sdf::Kernels& k = kernels();
    const double local_level = level / parent_from_local_.scale;
    if (k.form == sdf::Form::shape) return parent_from_local_ * k.bounds(params()).grown(local_level);
    const double reach = k.reach ? k.reach(params(), static_cast<int>(children_.size())) : 0;
    std::vector<Box2> below;
    const double factor = k.form == sdf::Form::warp ? k.factor(params()) : 1;
    for (const Subject& child : children_) below.push_back(child.bounds_of_isoline(local_level / factor + reach));
    if (k.form == sdf::Form::images) {
        Box2 out;
        for (const Similarity& local_from_image : k.images(params())) out = out.merged(local_from_image * below[0]);
        return parent_from_local_ * out;
    }
    return parent_from_local_ * k.bounds_over(params(), below);
}

double Subject::extent() const {
    const Box2 box = bounds();
    if (box.is_empty() || !box.is_finite()) {
        double largest = children_.empty() ? 0.1 : 0;
        for (const Subject& child : children_) largest = std::max(largest, child.extent());
        return largest;
    }
    return std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff());
}

bool Subject::keeps_outlines() const {
    const sdf::Kernels& k = kernels();
    if (k.form == sdf::Form::shape) {
        sdf::Outline pieces;
        if (k.outline) k.outline(params(), pieces);
        return !pieces.empty();
    }
    if (k.form == sdf::Form::warp) return false;
    if (k.form == sdf::Form::modify) {
        const sdf::Affine affine = k.affine(params());
        if (affine.offset != 0 || affine.absolute) return false;
    }
    if (k.form == sdf::Form::fold && k.slack(params()).below + k.slack(params()).above > 0) return false;
    return std::all_of(children_.begin(), children_.end(), [](const Subject& c) { return c.keeps_outlines(); });
}

void Subject::collect_outline(const Similarity& world_from_parent, sdf::Outline& out) const {
    const Similarity world_from_local = world_from_parent * parent_from_local_;
    const sdf::Kernels& k = kernels();
    if (k.form == sdf::Form::shape) {
        sdf::Outline pieces;
        if (k.outline) k.outline(params(), pieces);
        for (const sdf::Piece& piece : pieces) out.push_back(transformed(world_from_local, piece));
    } else if (k.form == sdf::Form::images) {
        for (const Similarity& local_from_image : k.images(params()))
            children_[0].collect_outline(world_from_local * local_from_image, out);
    } else {
        for (const Subject& child : children_) child.collect_outline(world_from_local, out);
    }
}

}  // namespace pinfield::conformance
