// Numbers with units as people write them, and back: "24mm" is 0.024 m, and stays in millimetres when it is edited.
#pragma once
#include <string>
#include <string_view>

#include "engine/core/error_codes.h"
#include "engine/core/units.h"
#include "engine/reflect/describe.h"

namespace pinfield {

/// What a field of this unit measures.
Dimension dimension_of(Unit unit);
/// The unit of fields that measure this; none where no field does.
Unit unit_of(const Dimension& dimension);
/// "um, mm, cm, m, in, ft"; empty for a plain number.
inline std::string suffixes_of(Unit unit) { return suffixes_of(dimension_of(unit)); }

/// A number as read: its value in the field's unit and how it was written.
struct Quantity {
    double value = 0;
    std::string_view digits;             ///< "24" of "24mm"
    const UnitSuffix* suffix = nullptr;  ///< null for a bare number
};

struct QuantityError {
    Code code = Code::wrong_type;
    std::string message;
    std::string hint;
    bool may_be_expression = false;  ///< it is more than a number: whoever reads expressions goes on from here
};

/// Reads a number for a field of this unit, or says in words what is wrong with it.
class QuantityResult {
public:
    QuantityResult(Quantity q) : quantity_(q), ok_(true) {}                // NOLINT(google-explicit-constructor)
    QuantityResult(QuantityError e) : error_(std::move(e)), ok_(false) {}  // NOLINT(google-explicit-constructor)
    explicit operator bool() const { return ok_; }
    const Quantity& operator*() const { return quantity_; }
    const Quantity* operator->() const { return &quantity_; }
    const QuantityError& error() const { return error_; }

private:
    Quantity quantity_;
    QuantityError error_;
    bool ok_;
};

QuantityResult read_quantity(std::string_view text, Unit unit);

/// A value in the style of `like`: its unit, at least its decimals, and digits that read back as exactly the same
/// double (in the bare unit where its own cannot say it).
std::string write_quantity(double value, Unit unit, std::string_view like = {});

}  // namespace pinfield
