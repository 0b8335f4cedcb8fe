#include "tests/program/enclosure.h"

#include <cassert>

#include "engine/core/at.h"
#include "tests/conformance/witness.h"

namespace pinfield::test {
namespace {

using sdf::Form;
using sdf::Interval;
using sdf::IntervalBox;

/// tree_value(), each of its numbers an interval: the same operations in the same order, so that rounding is covered too.
class Encloser {
public:
    explicit Encloser(const Field& field) : field_(field) {}

    Interval enclose(int index, const IntervalBox& p) const {
        const Op& op = at(field_.ops, index);
        const double* params = field_.params.data() + op.params;
        const sdf::Enclosures& over = conformance::witness_of(*op.kernels).enclosures;
        const Interval scale(op.scale);
        switch (op.kernels->form) {
            case Form::shape: return over.distance(params, op.local_from_field * p) * scale;
            case Form::fold: return fold(op, over, params, p);
            case Form::modify: return over.modify(params, child(op, 0, p) / scale).value * scale;
            case Form::images: return nearest_image(op, p);
            case Form::warp: {
                const sdf::IntervalWarped to = over.warped(params, op.local_from_field * p);
                const IntervalBox there = op.local_from_field.inverse() * IntervalBox{to.x.value, to.y.value};
                return Interval(op.kernels->factor(params)) * child(op, 0, there) + to.lift.value * scale;
            }
        }
        assert(false && "an op has one of the five forms");
        return Interval::everything();
    }

private:
    Interval child(const Op& op, int i, const IntervalBox& p) const {
        return enclose(at(field_.links, op.first_link + i), p);
    }
    Interval fold(const Op& op, const sdf::Enclosures& over, const double* params, const IntervalBox& p) const {
        const Interval scale(op.scale);
        Interval value = child(op, 0, p);
        for (int i = 1; i < op.child_count; ++i)
            value = over.combine(params, value / scale, child(op, i, p) / scale).value * scale;
        return value;
    }
    Interval nearest_image(const Op& op, const IntervalBox& p) const {
        Interval value(infinity);
        for (int i = 0; i < op.image_count; ++i)
            value = min(value, child(op, 0, at(field_.images, op.first_image + i).inverse() * p));
        return value;
    }

    const Field& field_;
};

}  // namespace

sdf::Interval natural_enclosure(const Field& field, int op, const Box2& box) { return Encloser(field).enclose(op, sdf::interval_box(box)); }

}  // namespace pinfield::test
