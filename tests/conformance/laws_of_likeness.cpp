// What stays the same when the author says the same thing otherwise: in another size, in another order.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "tests/conformance/laws.h"
#include "tests/conformance/packets.h"

namespace pinfield::conformance {
namespace {

/// A formula of which every length is multiplied: factor * f(x / factor, y / factor).
std::string formula_times(double factor, const std::string& text) {
    const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_name = (text[i] == 'x' || text[i] == 'y') && (i == 0 || !is_of_word(text[i - 1])) &&
                             (i + 1 == text.size() || !is_of_word(text[i + 1]));
        out += is_name ? fmt::format("({} / {})", text[i], factor) : std::string(1, text[i]);
    }
    return fmt::format("{} * ({})", factor, out);
}

Value times(double factor, const FieldType& field, const Value& value) {
    if (field.meta.meaning == Meaning::formula) return formula_times(factor, std::get<std::string>(value));
    if (field.meta.unit != Unit::metre) return value;
    if (const double* number = std::get_if<double>(&value)) return factor * *number;
    if (const Vec2* pair = std::get_if<Vec2>(&value)) return Vec2(factor * *pair);
    std::vector<Vec2> points = std::get<std::vector<Vec2>>(value);
    for (Vec2& point : points) point *= factor;
    return points;
}

/// With every length of it and below multiplied; nothing where a range or a contract refuses that.
std::optional<Subject> resized(const Subject& subject, double factor) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < subject.values().size(); ++i)
        values.push_back(times(factor, subject.type().fields[i], subject.values()[i]));
    if (!Subject::accepted(subject.type(), values)) return std::nullopt;
    std::vector<Subject> children;
    for (const Subject& child : subject.children()) {
        std::optional<Subject> resized_child = resized(child, factor);
        if (!resized_child) return std::nullopt;
        children.push_back(std::move(*resized_child));
    }
    Similarity parent_from_local = subject.parent_from_local();
    parent_from_local.offset *= factor;
    return Subject(subject.type(), std::move(values), std::move(children), parent_from_local);
}

bool is_symmetric(const sdf::Kernels& k, const double* params, const Operands& pairs) {
    for (std::size_t i = 0; i < pairs.a.size(); ++i)
        if (k.combine_hard(params, pairs.a[i], pairs.b[i]) != k.combine_hard(params, pairs.b[i], pairs.a[i])) return false;
    return true;
}

void compare(const Trial& trial, const Subject& other, std::string_view how) {
    for (std::size_t i = 0; i < trial.points.size(); ++i) {
        const Vec2& p = trial.points[i];
        const double value = trial.samples[i].value, found = other.value(p);
        if (!(std::fabs(found - value) <= trial.rounding(p)))
            trial.report(fmt::format("at ({}, {}): {}, {} {}", p.x(), p.y(), value, how, found));
    }
}

}  // namespace

/// Twice the size is twice the distance, to the bit: a power of two changes no digit of any product. What is not, has a length hidden in
/// it that the author never gave.
void size_is_a_matter_of_scale(const Trial& trial) {
    for (const double factor : {2.0, 0.5}) {
        const std::optional<Subject> other = resized(trial.subject, factor);
        if (!other) continue;  // a range ends between them
        for (std::size_t i = 0; i < trial.points.size(); ++i) {
            const Vec2& p = trial.points[i];
            const double value = trial.samples[i].value, found = other->value(factor * p);
            if (found != factor * value)
                trial.report(fmt::format("at ({}, {}): {}, {} times the size {}", p.x(), p.y(), value, factor, found));
        }
    }
}

/// A fold whose lattice counterpart knows no order has none either. One that strays from it without limit, such as a mean, has none to be
/// held to. Of several children it is the fold without any blend that may take them as they come: blends are folded in file order.
void order_of_children_is_no_matter(const Trial& trial) {
    const sdf::Kernels& k = trial.subject.kernels();
    if (k.form != sdf::Form::fold) return;
    const double* params = trial.subject.params();
    const sdf::Slack slack = k.slack(params);
    const Operands pairs = operands(trial.extent);
    if (!std::isfinite(slack.below + slack.above) || !is_symmetric(k, params, pairs)) return;
    for (std::size_t i = 0; i < pairs.a.size(); ++i) {
        const double a = pairs.a[i], b = pairs.b[i];
        const sdf::Partials f = k.combine_partials(params, a, b), g = k.combine_partials(params, b, a);
        const bool tie = std::fabs(a) == std::fabs(b);  // there either may win
        if (f.value != g.value || (!tie && (f.by_a != g.by_b || f.by_b != g.by_a)))
            trial.report(fmt::format("({}, {}): {} ({}, {}), swapped {} ({}, {})", a, b, f.value, f.by_a, f.by_b, g.value, g.by_a, g.by_b));
    }
    if (trial.subject.children().size() > 2 && slack.below + slack.above > 0) return;
    std::vector<Subject> children = trial.subject.children();
    std::reverse(children.begin(), children.end());
    compare(trial, Subject(trial.subject.type(), trial.subject.values(), std::move(children)), "with its children reversed");
}

/// Words that say something else of each point.
bool names_several(const std::vector<Value>& values) {
    return std::any_of(values.begin(), values.end(), [](const Value& value) {
        const auto* words = std::get_if<std::vector<std::string>>(&value);
        return words && std::any_of(words->begin(), words->end(), [&](const std::string& word) { return word != words->front(); });
    });
}

/// A chain of points is a figure, not a direction to draw it in.
void order_of_points_is_no_matter(const Trial& trial) {
    std::vector<Value> values = trial.subject.values();
    bool any = false;
    for (Value& value : values)
        if (auto* points = std::get_if<std::vector<Vec2>>(&value)) {
            std::reverse(points->begin(), points->end());
            any = true;
        }
    if (!any || names_several(trial.subject.values())) return;
    if (!Subject::accepted(trial.subject.type(), values)) return trial.report("refused with its points reversed");
    compare(trial, Subject(trial.subject.type(), std::move(values), trial.subject.children()), "with its points reversed");
}

}  // namespace pinfield::conformance
