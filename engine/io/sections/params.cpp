// params: {gap: 46mm, petal: gap / 2, teeth: {value: 9, min: 3, max: 24, step: 1, label: Teeth}}
#include <fmt/format.h>

#include <array>
#include <map>

#include "engine/io/calculate.h"
#include "engine/io/entries.h"
#include "engine/io/node_writer.h"
#include "engine/io/quantity.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"
#include "engine/io/value_writer.h"
#include "engine/scene/validate.h"

namespace pinfield::sections {
namespace {

/// A param as the text has it, and how far its value is known.
struct Entry {
    const SourceText* text = nullptr;  ///< that it stands in
    const YamlNode* key = nullptr;
    const YamlNode *value = nullptr, *min = nullptr, *max = nullptr, *step = nullptr, *label = nullptr, *unit = nullptr;
    enum class State : unsigned char { waiting, begun, done } state = State::waiting;
    Param param{};
    bool good = false;

    std::array<const YamlNode*, 4> numbers() const { return {value, min, max, step}; }
};

/// Values are worked out in whatever order they need each other.
class Params {
public:
    Params(ReadContext& context, const Sources& sources) : context_(context), sources_(sources) {}

    void take(const YamlNode& key, const YamlNode& value) {
        Entry entry{.text = &context_.source(), .key = &key};
        if (value.kind == YamlKind::map) take_map(entry, value);
        else entry.value = &value;
        if (!is_name(key.text) || is_reserved_name(key.text))
            return context_.report(Code::bad_name, key.span,
                                   fmt::format("{} {}", shortened(key.text), is_name(key.text) ? "means something in every expression" : "is not a valid name for a param"),
                                   is_name(key.text) ? "call it otherwise" : "small letters, digits and _, not beginning with a digit");
        if (value.kind == YamlKind::null) return report_missing_value(context_, key, value);
        if (const auto twin = entries_.find(key.text); twin != entries_.end()) return report_twin(key, twin->second);
        entry.param.name = key.text;
        entry.param.where = context_.source().place(key.span);
        context_.table_names.set(entry.param.name, {.kind = NamedValue::Kind::broken});
        order_.push_back(key.text);
        entries_.emplace(key.text, entry);
    }

    std::vector<Param> run() && {
        std::vector<Param> out;
        for (const std::string_view name : order_) resolve(entries_.at(name));
        for (const std::string_view name : order_)
            if (const Entry& entry = entries_.at(name); entry.good) out.push_back(entry.param);
        return out;
    }

private:
    void take_map(Entry& entry, const YamlNode& map) {
        static const std::vector<std::string_view> keys{"value", "min", "max", "step", "label", "unit"};
        const std::array<const YamlNode**, 6> places{&entry.value, &entry.min, &entry.max, &entry.step, &entry.label, &entry.unit};
        read_entries(context_, "a param", map, keys, [&](auto index, const YamlNode& value) { *places[static_cast<std::size_t>(index)] = &value; });
        if (!map.find("value"))
            context_.report(Code::missing_field, entry.key->span, fmt::format("the param {} needs a value", entry.key->text));
    }

    /// Of two in one file the reader of YAML has told.
    void report_twin(const YamlNode& key, const Entry& twin) {
        if (twin.text == &context_.source()) return context_.fail_silently();
        const Place here = context_.source().place(key.span);
        context_.report(Code::duplicate_id, key.span, taken_id(key.text), sources_.line_from(here, twin.param.where) + " has it");
    }

    /// The params that an entry's numbers are made of come first.
    void resolve(Entry& entry) {
        if (entry.state != Entry::State::waiting) return;
        const InText there(context_, entry.text);
        entry.state = Entry::State::begun;
        path_.push_back(entry.key->text);
        for (const YamlNode* number : entry.numbers())
            if (number && number->kind == YamlKind::scalar) resolve_names(*number);
        path_.pop_back();
        entry.state = Entry::State::done;
        if (!entry.value) return;
        entry.good = read(entry);
        if (!entry.good) return;
        const Param& param = entry.param;
        context_.table_names.set(param.name, {.value = param.value.value, .measure = {param.dimension, param.is_bare, false}});
    }

    void resolve_names(const YamlNode& number) {
        const auto expression = parse_expression(number.text);
        if (!expression) return;  // said when it is calculated
        for (const ExpressionName& name : expression->names) {
            const auto needed = entries_.find(name.text);
            if (needed == entries_.end()) continue;
            if (needed->second.state == Entry::State::begun) report_cycle(number, name.text);
            resolve(needed->second);
        }
    }

    void report_cycle(const YamlNode& number, std::string_view name) {
        std::string way;
        for (auto at = std::find(path_.begin(), path_.end(), name); at != path_.end(); ++at) way += std::string(*at) + " -> ";
        context_.report(Code::cyclic_param, number.span, fmt::format("params need each other in a circle: {}{}", way, name));
    }

    /// One of the numbers, which measures what the value does.
    std::optional<WrittenQuantity> number(const YamlNode* node, const Entry& entry) {
        if (!node) return {};
        const auto value = calculate(context_, *node, entry.param.dimension);
        return value ? std::optional(WrittenQuantity{*value, std::string(node->text)}) : std::nullopt;
    }

    bool read(Entry& entry) {
        const std::size_t errors = context_.errors_so_far();
        for (const YamlNode* node : entry.numbers())
            if (node && node->kind != YamlKind::scalar) context_.report(Code::wrong_shape, node->span, "a number is due here");
        if (context_.errors_so_far() != errors) return false;
        Param& param = entry.param;
        const auto value = calculate(context_, *entry.value);
        if (!value) return false;
        param.value = {value->value, std::string(entry.value->text)};
        param.value_where = context_.source().place(entry.value->span);
        param.dimension = value->measure.dimension;
        param.is_bare = value->measure.bare;
        param.is_calculated = !value->is_literal;
        if (entry.unit && !take_unit(entry)) return false;
        take_set_value(param);
        param.min = number(entry.min, entry);
        param.max = number(entry.max, entry);
        param.step = number(entry.step, entry);
        if (entry.label) param.label = entry.label->text;
        if (context_.errors_so_far() == errors) check_range(entry);
        return context_.errors_so_far() == errors;
    }

    /// What a bare value is a number of, and what the editor shows it in.
    bool take_unit(Entry& entry) {
        const UnitSuffix* unit = find_suffix(entry.unit->text);
        Param& param = entry.param;
        param.unit = entry.unit->text;
        if (!unit) return context_.report(Code::unknown_unit, entry.unit->span, fmt::format("{} is no unit", shortened(param.unit))), false;
        const bool adapts = param.is_bare && param.dimension.is_plain();
        if (!adapts && unit->dimension != param.dimension)
            return context_.report(Code::wrong_dimension, entry.unit->span,
                                   fmt::format("{} is {}, and the value is {}", param.unit, measured(unit->dimension), measured(param.dimension))),
                   false;
        param.dimension = unit->dimension;
        param.is_bare = false;
        return true;
    }

    /// A value that was given in place of the text's, as the text would say it.
    void take_set_value(Param& param) const {
        if (!context_.set_params) return;
        const auto set = context_.set_params->find(param.name);
        if (set == context_.set_params->end()) return;
        param.value = {set->second, write_quantity(set->second, unit_of(param.dimension), param.value.text)};
    }

    void check_range(const Entry& entry) {
        const Param& param = entry.param;
        if (param.min && param.max && param.max->value < param.min->value)
            return context_.report(Code::out_of_range, entry.max->span, fmt::format("max is {}, and min is {}", param.max->text, param.min->text));
        if (param.step && param.step->value <= 0) return context_.report(Code::out_of_range, entry.step->span, "step must be above 0");
        const bool low = param.min && param.value.value < param.min->value;
        if (low || (param.max && param.value.value > param.max->value))
            context_.report(Code::out_of_range, entry.value->span,
                            fmt::format("{} is {}, {} its {} of {}", param.name, param.value.text, low ? "below" : "above", low ? "min" : "max",
                                        low ? param.min->text : param.max->text));
    }

    ReadContext& context_;
    const Sources& sources_;
    std::map<std::string_view, Entry> entries_;
    std::vector<std::string_view> order_, path_;
};

/// Those of a file; `count`: those of the files before.
void take_all(ReadContext& context, Params& params, const YamlNode& section, std::size_t& count) {
    if (section.is_empty()) return;
    if (section.kind != YamlKind::map)
        return context.report(Code::wrong_shape, section.span, "params are due here", "write params: {gap: 46mm}");
    count += section.entries();
    if (count > context.limits.params)
        return context.report(Code::too_many_params, section.span, fmt::format("{} params; at most {} are read", count, context.limits.params));
    for (std::size_t i = 0; i < section.entries() && !context.full(); ++i)
        if (is_plain_key(section.key(i))) params.take(section.key(i), section.value(i).resolved());
}

void read_all(ReadContext& context, Scene& scene, std::span<const SectionText> texts) {
    Params params(context, scene.sources);
    std::size_t count = 0;
    for (const SectionText& section : texts) {
        const InText there(context, section.text);
        take_all(context, params, *section.value, count);
    }
    scene.params = std::move(params).run();
}

std::string entry_of(const Param& param) {
    const std::string value = write_text(param.value.text);
    std::vector<std::string> entries;
    const auto add = [&](std::string_view key, const std::string& text) {
        if (!text.empty()) entries.push_back(fmt::format("{}: {}", key, write_text(text)));
    };
    add("min", param.min ? param.min->text : "");
    add("max", param.max ? param.max->text : "");
    add("step", param.step ? param.step->text : "");
    add("label", param.label);
    add("unit", param.unit);
    if (entries.empty()) return fmt::format("{}: {}", param.name, value);
    entries.insert(entries.begin(), "value: " + value);
    return fmt::format("{}: {}", param.name, flow_map(entries));
}

std::string write(const Scene& scene) {
    std::string out;
    for (const Param& param : scene.params)
        if (!is_elsewhere(scene, param.where)) out += fmt::format("  {}\n", entry_of(param));
    return out.empty() ? out : "params:\n" + out;
}

std::string schema_text() {
    const std::string number = schema::any_number();
    return schema::named_map(fmt::format(
        R"({{"anyOf": [{0}, {{"type": "object", "required": ["value"], "additionalProperties": false, "properties": {{"value": {0}, "min": {0}, "max": {0}, "step": {0}, "label": {{"type": ["string", "number"]}}, "unit": {{"type": "string"}}}}}}]}})",
        number));
}

}  // namespace

extern const Section params{
    .key = "params",
    .read_all = read_all,
    .write = write,
    .schema = schema_text,
    .same = [](const Scene& a,
               const Scene& b) { return std::equal(a.params.begin(), a.params.end(), b.params.begin(), b.params.end(), same_param); },
    .phase = Section::Phase::params,
};

}  // namespace pinfield::sections
