#include "tests/conformance/parameters.h"

#include <algorithm>
#include <cmath>

#include "engine/core/at.h"

namespace pinfield::conformance {
namespace {

double random_number(const FieldMeta& meta, CounterRng& rng) {
    const bool bounded = std::isfinite(meta.min.value) && std::isfinite(meta.max.value);
    if (bounded && meta.unit != Unit::metre) return rng.in(meta.min.value, meta.max.value);
    const double size = 0.002 * std::exp(rng.in(0, 4));  // 2 mm to 11 cm
    if (std::isfinite(meta.min.value)) return std::min(meta.min.value + size, meta.max.value);
    return rng.uniform() < 0.5 ? size : -size;
}

/// Corners at growing angles about a centre: never self-crossing, seldom convex.
std::vector<Vec2> random_ring(CounterRng& rng) {
    const int count = 3 + static_cast<int>(rng.in(0, 9));
    const Vec2 centre{rng.in(-0.05, 0.05), rng.in(-0.05, 0.05)};
    const double direction = rng.uniform() < 0.5 ? 1 : -1;
    std::vector<Vec2> out;
    for (int i = 0; i < count; ++i) {
        const double angle = direction * 6.2831853 * (i + rng.in(0, 0.9)) / count;
        out.push_back(centre + rng.in(0.005, 0.08) * Vec2(std::cos(angle), std::sin(angle)));
        if (rng.uniform() < 0.1) out.push_back(out.back());  // coincident vertices are harmless
    }
    return out;
}

Value random_value(const FieldType& field, CounterRng& rng) {
    switch (field.kind) {
        case FieldKind::boolean: return rng.uniform() < 0.5;
        case FieldKind::integer: {
            const double lo = field.meta.min.value, hi = std::min(field.meta.max.value, lo + 10);
            return static_cast<std::int64_t>(std::floor(rng.in(lo, hi + 1)));
        }
        case FieldKind::number: return random_number(field.meta, rng);
        case FieldKind::vec2: {
            if (field.meta.step == 1) {  // counts
                const double first = std::floor(rng.in(field.meta.min.value, field.meta.min.value + 5));
                return Vec2(first, std::floor(rng.in(field.meta.min.value, field.meta.min.value + 5)));
            }
            const double x = random_number(field.meta, rng);
            return Vec2(x, random_number(field.meta, rng));
        }
        case FieldKind::points: return random_ring(rng);
        case FieldKind::choice: {
            const auto n = static_cast<double>(field.choices.size());
            return std::string(at(field.choices, rng.in(0, n)));
        }
        case FieldKind::choices: {
            std::vector<std::string> out(static_cast<std::size_t>(rng.in(1, 5)));
            for (std::string& word : out)
                word = at(field.choices, rng.in(0, static_cast<double>(field.choices.size())));
            return out;
        }
        default: return field.initial;
    }
}

/// What to try in place of a number, among them the numbers of other fields.
std::vector<double> extremes(const NodeType& type, const FieldMeta& meta) {
    std::vector<double> out{0, -0.0, 1e-9, 1e-6, 1e3, meta.min.value, meta.max.value};
    for (const double limit : {meta.min.value, meta.max.value})  // next to 0 is no number of metres that a product survives
        if (std::isfinite(limit) && limit != 0) out.insert(out.end(), {std::nextafter(limit, infinity), std::nextafter(limit, -infinity)});
    for (const FieldType& other : type.fields) {
        if (other.common || other.meta.unit != meta.unit) continue;
        if (const double* x = std::get_if<double>(&other.initial))
            for (const double factor : {0.5, 1.0, 2.0})
                for (const double nudge : {-1e-9, 0.0, 1e-9}) out.push_back(*x * factor * (1 + nudge));
        if (const Vec2* v = std::get_if<Vec2>(&other.initial)) out.insert(out.end(), {v->x(), v->y()});
    }
    out.erase(std::remove_if(out.begin(), out.end(), [](double x) { return !std::isfinite(x); }), out.end());
    return out;
}

std::vector<Value> degenerate_field(const NodeType& type, const FieldType& field) {
    std::vector<Value> out;
    const std::vector<double> numbers = extremes(type, field.meta);
    if (field.kind == FieldKind::number) out.assign(numbers.begin(), numbers.end());
    if (field.kind == FieldKind::integer)
        for (const double x : numbers) out.emplace_back(static_cast<std::int64_t>(x));
    if (field.kind == FieldKind::vec2) {
        const Vec2 now = std::get<Vec2>(field.initial);
        for (const double x : numbers) out.insert(out.end(), {Vec2(x, now.y()), Vec2(now.x(), x), Vec2(x, x)});
        for (const FieldType& other : type.fields)
            if (!other.common && other.kind == FieldKind::vec2) {
                const Vec2 partner = std::get<Vec2>(other.initial);
                out.insert(out.end(), {partner, Vec2(0.5 * (now + partner)), Vec2(2 * now - partner)});
                out.emplace_back(Vec2(partner + Vec2(1e-9, 0)));
            }
    }
    if (field.kind == FieldKind::points) {
        const double s = 0.03;
        out.emplace_back(std::vector<Vec2>{{0, 0}, {s, 0}, {s, s}, {s, s}, {0, s}, {0, 0}});            // coincident corners
        out.emplace_back(std::vector<Vec2>{{0, 0}, {s, 0}, {2 * s, 0}, {2 * s, s}, {0, s}});            // straight corner
        out.emplace_back(std::vector<Vec2>{{0, 0}, {s, 0}, {s, 1e-9}});                                 // sliver
        out.emplace_back(std::vector<Vec2>{{0, 0}, {2 * s, 0}, {2 * s, s}, {s, 0}, {0, s}});            // corner on an edge
        out.emplace_back(std::vector<Vec2>{{0, 0}, {0, s}, {s, s}, {s, 0}});                            // clockwise
        out.emplace_back(std::vector<Vec2>{{1e3, 1e3}, {1e3 + 1, 1e3}, {1e3, 1e3 + 1}});                // far away
    }
    return out;
}

/// Random sets with one length, then another, of 0, both ways of each yes or no: a rim of no thickness is there for what is filled only.
std::vector<Values> without_lengths(const NodeType& type) {
    std::vector<Values> out;
    CounterRng rng(21);
    const auto own = static_cast<std::size_t>(type.own_fields);
    for (int draw = 0; draw < 5; ++draw)
        for (std::size_t i = 0; i < own; ++i) {
            const FieldMeta& meta = type.fields[i].meta;
            if (type.fields[i].kind != FieldKind::number || meta.unit != Unit::metre || meta.min.open || meta.min.value != 0) continue;
            Values values = random_values(type, rng);
            values[i] = 0.0;
            if (Subject::accepted(type, values)) out.push_back(values);
            for (std::size_t k = 0; k < own; ++k) {
                bool* flag = std::get_if<bool>(&values[k]);
                if (!flag) continue;
                *flag = !*flag;
                if (Subject::accepted(type, values)) out.push_back(values);
            }
        }
    return out;
}

Subject child(const Catalog& catalog, std::string_view key, Values values, const Similarity& at,
              std::vector<Subject> below = {}) {
    return {*catalog.find(key), std::move(values), std::move(below), at};
}

Similarity placed(double x, double y, double cosine = 1, double sine = 0) { return {cosine, sine, 1, false, {x, y}}; }
Similarity scaled(double factor, const Similarity& s) { return {s.cosine, s.sine, factor * s.scale, s.mirrored, factor * s.offset}; }

/// Of a lattice: the factor that makes a length the smaller of its steps, so that its child meets a few of its copies, not thousands.
double size_in_cells(const NodeType& type, const Values& values, double length) {
    if (!type.kernels->lattice) return 1;
    const Vec2 step = type.kernels->lattice(pack(type, values, type.kernels->derived_count).data()).step;
    return std::min(step.x() > 0 ? step.x() : infinity, step.y() > 0 ? step.y() : infinity) / length;
}

}  // namespace

Values defaults_of(const NodeType& type) {
    Values out;
    for (std::size_t i = 0; i < static_cast<std::size_t>(type.own_fields); ++i) out.push_back(type.fields[i].initial);
    return out;
}

Values random_values(const NodeType& type, CounterRng& rng) {
    for (int attempt = 0; attempt < 200; ++attempt) {
        Values out;
        for (std::size_t i = 0; i < static_cast<std::size_t>(type.own_fields); ++i)
            out.push_back(random_value(type.fields[i], rng));
        if (Subject::accepted(type, out)) return out;
    }
    return defaults_of(type);
}

std::vector<Values> degenerate_values(const NodeType& type) {
    std::vector<Values> out;
    for (std::size_t i = 0; i < static_cast<std::size_t>(type.own_fields); ++i)
        for (const Value& extreme : degenerate_field(type, type.fields[i])) {
            Values values = defaults_of(type);
            values[i] = extreme;
            if (Subject::accepted(type, values)) out.push_back(std::move(values));
        }
    const std::vector<Values> thin = without_lengths(type);
    out.insert(out.end(), thin.begin(), thin.end());
    return out;
}

std::vector<Subject> subjects_of(const Catalog& catalog, const NodeType& type, const Values& values) {
    if (type.kernels->form == sdf::Form::shape) return {Subject(type, values)};
    const auto disc = [&](double r, const Similarity& at) { return child(catalog, "circle", {r}, at); };
    const auto box = [&](double w, double h, const Similarity& at) { return child(catalog, "box", {Vec2(w, h), 0.0}, at); };
    std::vector<Subject> out;
    if (type.meta.children.max == 1) {
        const double size = size_in_cells(type, values, 0.12), large = size_in_cells(type, values, 0.06);
        out.emplace_back(type, values, std::vector{disc(0.03, scaled(size, placed(0.05, 0.01)))});
        out.emplace_back(type, values, std::vector{box(0.05, 0.02, scaled(size, placed(0.02, 0.01, 0.6, 0.8)))});
        out.emplace_back(type, values, std::vector{child(catalog, "intersection", {}, scaled(large, placed(0.03, 0)),
                                                         {disc(0.04, placed(-0.02, 0)), box(0.05, 0.05, placed(0.02, 0.03))})});
        return out;
    }
    out.emplace_back(type, values, std::vector{disc(0.03, placed(-0.01, 0)), disc(0.02, placed(0.02, 0.01))});
    out.emplace_back(type, values, std::vector{box(0.06, 0.04, placed(0, 0)), disc(0.02, placed(0.03, 0.02)),
                                               box(0.02, 0.07, placed(-0.01, 0.01, 0.8, 0.6))});
    out.emplace_back(type, values, std::vector{box(0.06, 0.04, placed(0, 0)), box(0.06, 0.04, placed(0, 0))});
    out.emplace_back(type, values, std::vector{disc(0.02, placed(0, 0))});
    out.emplace_back(type, values, std::vector{child(catalog, "complement", {}, placed(0, 0), {disc(0.05, placed(0, 0))}),
                                               disc(0.02, placed(0.04, 0))});
    out.emplace_back(type, values, std::vector{child(catalog, "intersection", {}, placed(0, 0, 0.8, 0.6),
                                                     {box(0.1, 0.02, placed(0, 0)), box(0.1, 0.02, placed(0, 0.01, 0.96, 0.28))}),
                                               disc(0.02, placed(0, 0.02))});
    return out;
}

}  // namespace pinfield::conformance
