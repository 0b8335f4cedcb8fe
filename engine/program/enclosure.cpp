#include "engine/program/enclosure.h"

#include <cassert>

#include "engine/program/tree.h"

namespace pinfield {
namespace {

using sdf::Form;
using sdf::Interval;
using sdf::IntervalBox;

/// As tree_value(), each of its numbers an interval.
class Encloser {
public:
    explicit Encloser(const Field& field) : field_(field) {}

    Interval enclose(int index, const IntervalBox& p) const {
        const Op& op = field_.ops[static_cast<std::size_t>(index)];
        const sdf::Enclosures& enclosures = op.kernels->enclosures;
        const double* params = field_.params.data() + op.params;
        const Interval scale(op.scale);
        switch (op.kernels->form) {
            case Form::shape: return enclosures.distance(params, op.local_from_field * p) * scale;
            case Form::modify: return enclosures.modify(params, child(op, 0, p) / scale) * scale;
            case Form::fold: {
                Interval value = child(op, 0, p);
                for (int i = 1; i < op.child_count; ++i) value = enclosures.combine(params, value / scale, child(op, i, p) / scale) * scale;
                return value;
            }
            case Form::images: {
                Interval value(infinity);
                for (int i = 0; i < op.image_count; ++i)
                    value = min(value, child(op, 0, field_.images[static_cast<std::size_t>(op.first_image + i)].inverse() * p));
                return value;
            }
            case Form::warp: {
                const sdf::IntervalWarped warped = enclosures.warped(params, op.local_from_field * p);
                const IntervalBox there = op.local_from_field.inverse() * IntervalBox{warped.x.value, warped.y.value};
                return Interval(op.kernels->factor(params)) * child(op, 0, there) + warped.lift.value * scale;
            }
        }
        assert(false && "an op has one of the five forms");
        return Interval::everything();
    }

private:
    Interval child(const Op& op, int i, const IntervalBox& p) const {
        return enclose(field_.links[static_cast<std::size_t>(op.first_link + i)], p);
    }

    const Field& field_;
};

}  // namespace

Interval natural_enclosure(const Field& field, int op, const Box2& box) { return Encloser(field).enclose(op, interval_box(box)); }

Interval tree_enclosure(const Field& field, int op, const Box2& box) {
    const Interval natural = natural_enclosure(field, op, box);
    if (!box.is_finite()) return natural;
    const Vec2 centre = box.centre();
    const double value = tree_value(field, op, centre);
    return sdf::sharpened(natural, centre, value, field.ops[static_cast<std::size_t>(op)].exactness.lipschitz * 0.5 * length(box.size()));
}

}  // namespace pinfield
