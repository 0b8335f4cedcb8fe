#include "engine/io/home_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/at.h"
#include "engine/io/quantity.h"

namespace pinfield {
namespace {

constexpr double steps_at_line = 1e9, steps_at_name = 1e6;  // of what is written, in 1 m, deg, s ...
constexpr int most_trials = 8;

const FieldSlot& slot_of(const Scene& scene, const SetField& edit) { return at(scene.find(edit.node)->fields, edit.field); }

using Numbers = std::vector<double>;

Numbers numbers_of(const Value& value) {
    if (const auto* point = std::get_if<Vec2>(&value)) return {point->x(), point->y()};
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return {static_cast<double>(*whole)};
    return {std::get<double>(value)};
}

Value value_of(const Numbers& numbers, const Value& like) {
    if (std::holds_alternative<Vec2>(like)) return Vec2(numbers[0], numbers[1]);
    if (std::holds_alternative<std::int64_t>(like)) return static_cast<std::int64_t>(std::llround(numbers[0]));
    return numbers[0];
}

/// The double that a decimal text of it stands for: 0.035, not 0.034999999999999996.
double rounded(double x, double steps) { return std::round(x * steps) / steps; }
bool is_near(double a, double b) { return std::fabs(a - b) <= 2 / steps_at_line * std::max(1.0, std::fabs(b)); }
bool are_near(const Numbers& a, const Numbers& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!is_near(a[i], b[i])) return false;
    return true;
}

Failure first_error(const Reading& reading) {
    for (const Diagnostic& d : reading.diagnostics)
        if (d.severity == Severity::error)
            return {fmt::format("line {}: {}", reading.scene.sources.line_column(d.where).line, d.message)};
    return {"the table cannot be read with it"};
}

bool has_same_nodes(const Scene& a, const Scene& b) {
    const std::vector<NodeId> x = a.all(), y = b.all();
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [&](NodeId i, NodeId j) { return a.find(i)->type == b.find(j)->type; });
}

/// Has no value changed that stands at its node as it is? `edit`: nor any that stands in another line; null: whichever.
bool is_confined(const Scene& before, const Scene& after, const SetField* edit) {
    for (const NodeId id : before.all()) {
        const Node &was = *before.find(id), &is = *after.find(id);
        for (std::size_t i = 0; i < was.fields.size(); ++i) {
            if (identical(was.fields[i].value, is.fields[i].value)) continue;
            const bool may = edit ? static_cast<int>(i) == edit->field && is_same_line(before, *edit, was) : was.origin || was.fields[i].written;
            if (!may) return false;
        }
    }
    return true;
}

/// A field's own text, tried with other numbers.
class Line {
public:
    Line(const Reading& now, const SetField& edit, const Limits& limits)
        : now_(now), edit_(edit), limits_(limits), node_(*now.scene.find(edit.node)), due_(numbers_of(edit.value)), is_(numbers_of(slot().value)),
          said_(is_), literal_(is_.size(), !slot().where) {
        const YamlNode* value = slot().where ? node_at(*now.tree, slot().where.span) : nullptr;
        if (value) read_text(*value);
        else said_ = numbers_of(at(node_.type->fields, edit.field).initial);
        slot().value = value_of(said_, edit.value);  // what the text says, so that what does not change keeps its bytes
    }

    Result<PatchedText> solve() {
        Numbers direct = said_, moved = said_;
        for (std::size_t i = 0; i < due_.size(); ++i) {
            if (due_[i] == is_[i]) continue;
            direct[i] = due_[i];
            moved[i] = rounded(said_[i] + due_[i] - is_[i], steps_at_line);
        }
        for (const Numbers& numbers : {direct, moved})
            if (Result<PatchedText> tried = with(numbers); tried && are_near(numbers_in(*tried), due_)) return tried;
        return solve_linear();
    }

private:
    FieldSlot& slot() { return at(node_.fields, edit_.field); }

    void read_text(const YamlNode& value) {
        const Unit unit = at(node_.type->fields, edit_.field).meta.unit;
        for (std::size_t i = 0; i < said_.size(); ++i) {
            const YamlNode* number = said_.size() == 1 ? &value : value.kind == YamlKind::sequence && value.items.size() == said_.size() ? value.items[i] : nullptr;
            if (!number || number->kind != YamlKind::scalar) continue;
            const QuantityResult read = read_quantity(number->text, unit);
            literal_[i] = static_cast<bool>(read);
            if (read) said_[i] = read->value;
        }
    }

    Result<PatchedText> with(const Numbers& numbers) {
        const Result<Splice> splice = splice_for(now_, node_, SetField{edit_.node, edit_.field, value_of(numbers, edit_.value), true});
        if (!splice) return tl::unexpected(splice.error());
        Result<PatchedText> out = read_home(now_, *splice, limits_);
        if (out && !is_confined(now_.scene, out->reading.scene, &edit_)) return failure("the text would change more than this value");
        return out;
    }
    Numbers numbers_in(const PatchedText& text) const { return numbers_of(slot_of(text.reading.scene, edit_).value); }

    /// Of a turned or mirrored copy: the value is linear in what the text says.
    Result<PatchedText> solve_linear() {
        if (std::find(literal_.begin(), literal_.end(), false) != literal_.end())
            return failure("what stands there is calculated for each copy: change it in the text");
        const double h = std::holds_alternative<std::int64_t>(edit_.value) ? 1 : 1e-3;
        std::vector<Numbers> columns;
        for (std::size_t i = 0; i < due_.size(); ++i) {
            Numbers aside = said_;
            aside[i] += h;
            const Result<PatchedText> tried = with(aside);
            if (!tried) return tl::unexpected(tried.error());
            Numbers column = numbers_in(*tried);
            for (std::size_t k = 0; k < column.size(); ++k) column[k] = (column[k] - is_[k]) / h;
            columns.push_back(std::move(column));
        }
        Numbers numbers = said_;
        if (due_.size() == 1) {
            if (columns[0][0] == 0) return failure("what stands there does not change it");
            numbers[0] += (due_[0] - is_[0]) / columns[0][0];
        } else {
            const double a = columns[0][0], b = columns[1][0], c = columns[0][1], d = columns[1][1], det = a * d - b * c;
            if (det == 0) return failure("what stands there does not change it");
            const double x = due_[0] - is_[0], y = due_[1] - is_[1];
            numbers[0] += (d * x - b * y) / det;
            numbers[1] += (a * y - c * x) / det;
        }
        for (double& number : numbers) number = rounded(number, steps_at_line);
        Result<PatchedText> out = with(numbers);
        if (out && !are_near(numbers_in(*out), due_)) return failure("no number there gives this value");
        return out;
    }

    const Reading& now_;
    const SetField& edit_;
    const Limits& limits_;
    Node node_;
    Numbers due_, is_, said_;
    std::vector<bool> literal_;
};

}  // namespace

bool is_number(const Value& value) {
    return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value) || std::holds_alternative<Vec2>(value);
}

bool is_same_line(const Scene& scene, const SetField& edit, const Node& other) {
    const Node& node = *scene.find(edit.node);
    if (other.type != node.type) return false;
    const FieldSlot& slot = at(node.fields, edit.field);
    return slot.is_explicit && slot.where ? at(other.fields, edit.field).where == slot.where : other.key == node.key;
}

Result<PatchedText> read_home(const Reading& now, const Splice& splice, const Limits& limits) {
    const SourceText& source = now.source();
    const TextPatch patch{source.place(splice.replaced), splice.text};
    PatchedText out{{patch}, read_again(now, apply(patch, source.text()), limits), 1};
    if (!out.reading.ok()) return tl::unexpected(first_error(out.reading));
    if (!has_same_nodes(now.scene, out.reading.scene)) return failure("nodes would come or go with it");
    out.reading.scene.take_ids_of(now.scene);
    if (!is_confined(now.scene, out.reading.scene, nullptr)) return failure("the text would change more than this value");
    return out;
}

Result<PatchedText> solve_number(const Reading& now, const SetField& edit, std::optional<double> start, const std::string& name,
                                 const std::function<Result<PatchedText>(double)>& trial, const Limits& limits) {
    const FieldSlot& slot = slot_of(now.scene, edit);
    if (!is_number(edit.value) || !slot.written) return failure(fmt::format("{} makes no number of it", name));
    const Numbers due = numbers_of(edit.value), is = numbers_of(slot.value);
    std::size_t part = 0;
    for (const WrittenPart& written : *slot.written)
        if (const auto i = static_cast<std::size_t>(written.index); i < due.size() && std::fabs(due[i] - is[i]) >= std::fabs(due[part] - is[part])) part = i;

    Result<PatchedText> tried = failure(fmt::format("no number of {} gives this value", name));
    const auto value_at = [&](double x) -> std::optional<double> {
        tried = trial(x);
        if (!tried || !tried->reading.scene.find(edit.node)) return {};
        return numbers_of(slot_of(tried->reading.scene, edit).value)[part];
    };
    // What the text says of a bare name; else from where it is, as if both moved alike, and on along the chord.
    std::optional<std::pair<double, double>> before;
    if (start) before = {*start, is[part]};
    double x = rounded(start ? *start + due[part] - is[part] : due[part], steps_at_name);
    for (int k = 0; k < most_trials; ++k) {
        const std::optional<double> y = value_at(x);
        if (!y) return tried;
        const double slope = before && before->first != x ? (*y - before->second) / (x - before->first) : 1;
        if (std::fabs(*y - due[part]) <= std::max(std::fabs(slope), 1e-9) / steps_at_name) break;
        if (slope == 0) return failure(fmt::format("{} does not change it", name));
        if (k + 1 == most_trials) return failure(fmt::format("no number of {} gives this value", name));
        before = {x, *y};
        x = rounded(x + (due[part] - *y) / slope, steps_at_name);
    }
    Numbers rest = due;
    rest[part] = numbers_of(slot_of(tried->reading.scene, edit).value)[part];
    if (are_near(rest, numbers_of(slot_of(tried->reading.scene, edit).value))) return tried;
    Result<PatchedText> whole = patch_line(tried->reading, SetField{edit.node, edit.field, value_of(rest, edit.value), true}, limits);
    if (!whole) return whole;
    whole->patches.insert(whole->patches.begin(), tried->patches.begin(), tried->patches.end());
    return whole;
}

Result<PatchedText> patch_line(const Reading& now, const SetField& edit, const Limits& limits) {
    if (edit.is_explicit && is_number(edit.value)) return Line(now, edit, limits).solve();
    const Result<Splice> splice = splice_for(now, *now.scene.find(edit.node), edit);
    if (!splice) return tl::unexpected(splice.error());
    Result<PatchedText> out = read_home(now, *splice, limits);
    if (!out) return out;
    if (!is_confined(now.scene, out->reading.scene, &edit)) return failure("the text would change more than this value");
    if (edit.is_explicit && !identical(slot_of(out->reading.scene, edit).value, edit.value)) return failure("what stands there makes another value of it");
    return out;
}

}  // namespace pinfield
