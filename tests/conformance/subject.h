// What a law is tried on: a shape, or an operation over placed children, evaluated straight from its kernels. Slow and plain on
// purpose: it shares nothing with the Program that the engine compiles, so that the two can be compared.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/core/geometry.h"
#include "engine/reflect/catalog.h"
#include "engine/sdf/kernels.h"

namespace pinfield::conformance {

class Subject {
public:
    Subject(const NodeType& type, std::vector<Value> values, std::vector<Subject> children = {},
            const Similarity& parent_from_local = {});

    /// Values, or null when a range or a contract refuses them.
    static bool accepted(const NodeType& type, const std::vector<Value>& values);

    const NodeType& type() const { return *type_; }
    const sdf::Kernels& kernels() const { return *type_->kernels; }
    const double* params() const { return params_.data(); }
    const std::vector<Value>& values() const { return values_; }
    const std::vector<Subject>& children() const { return children_; }
    const Similarity& parent_from_local() const { return parent_from_local_; }
    bool is_shape() const { return kernels().form == sdf::Form::shape; }
    /// "box {size: [0.1, 0.05], round: 0} over circle {...}", for messages.
    std::string text() const;

    /// In the parent's frame, as is everything below.
    double value(const Vec2& p) const { return sample(p).value; }
    sdf::Sample sample(const Vec2& p) const;
    Exactness exactness() const;
    Box2 bounds() const { return bounds_of_isoline(0); }
    /// Largest absolute coordinate of the bounds where they are finite, else 0.1 m: the unit of the tolerances.
    double extent() const;
    /// Pieces of the outlines of all shapes beneath (of images too): the true outline is a part of them, unless an operation
    /// changes the field's values.
    void collect_outline(const Similarity& world_from_parent, sdf::Outline& out) const;
    bool keeps_outlines() const;
    /// Of a lattice: where the copies stand that a point of its middle cell asks.
    std::vector<Vec2> neighbour_offsets() const;

private:
    sdf::Sample local_sample(const Vec2& p) const;
    sdf::Sample nearest_of_neighbours(const Vec2& p) const;
    Box2 bounds_of_isoline(double level) const;

    const NodeType* type_;
    std::vector<Value> values_;
    std::vector<double> params_;
    std::vector<Subject> children_;
    Similarity parent_from_local_;
};

}  // namespace pinfield::conformance
