#include "engine/io/script_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/io/value_reader.h"

namespace pinfield {
namespace {

using Kind = ScriptStep::Kind;

struct StepForm {
    std::string_view word;
    Kind kind;
    std::array<std::string_view, 4> keys;  ///< of a map; none: the step holds a single word
    std::size_t required;                  ///< how many of the keys must be there
};

constexpr std::array forms{
    StepForm{"action", Kind::action, {}, 0},
    StepForm{"select", Kind::select, {}, 0},
    StepForm{"screenshot", Kind::screenshot, {}, 0},
    StepForm{"set", Kind::set, {"node", "field", "value"}, 3},
    StepForm{"drag", Kind::drag, {"from", "to"}, 2},
    StepForm{"key", Kind::key, {"press", "ticks"}, 1},
    StepForm{"wait", Kind::wait, {"ticks"}, 1},
    StepForm{"expect", Kind::expect, {"node", "field", "value", "tolerance"}, 3},
};

FieldType field_of(std::string_view key) {
    FieldMeta meta;
    if (key == "from" || key == "to") {
        meta.unit = Unit::metre;
        return {key, FieldKind::vec2, meta, {}, {}, false};
    }
    meta.min = from(0);
    meta.max = to(1e7);
    return {key, FieldKind::integer, meta, {}, {}, false};
}

void read_key(ReadContext& context, ScriptStep& step, std::string_view key, const YamlNode& value) {
    if (key == "value" || key == "tolerance") {
        (key == "value" ? step.value : step.tolerance) =
            std::string(value.kind == YamlKind::scalar ? value.text : context.source.slice(value.span));
        return;
    }
    if (key == "from" || key == "to" || key == "ticks") {
        const auto read = read_value(context, field_of(key), value);
        if (!read) return;
        if (key == "ticks")
            step.ticks = static_cast<int>(std::get<std::int64_t>(*read));
        else
            (key == "from" ? step.from : step.to) = std::get<Vec2>(*read);
        return;
    }
    if (value.kind != YamlKind::scalar)
        return context.report(Code::wrong_shape, value.span, fmt::format("{} is a single word", key));
    (key == "node" ? step.node : key == "field" ? step.field : step.name) = std::string(value.text);
}

void read_map(ReadContext& context, ScriptStep& step, const StepForm& form, const YamlNode& word,
              const YamlNode& body) {
    std::vector<std::string_view> known;
    for (const std::string_view key : form.keys)
        if (!key.empty()) known.push_back(key);
    if (body.kind != YamlKind::map)
        return context.report(Code::wrong_shape, word.span,
                              fmt::format("{} takes {}", form.word, fmt::join(known, ", ")));
    for (std::size_t i = 0; i < body.entries(); ++i) {
        const YamlNode& value = body.value(i).resolved();
        if (std::find(known.begin(), known.end(), body.key(i).text) == known.end())
            context.report(Code::unknown_key, body.key(i).span,
                           fmt::format("{} has no {}", form.word, body.key(i).text),
                           suggestion(body.key(i).text, known));
        else if (value.kind == YamlKind::null)
            report_missing_value(context, body.key(i), value);
        else
            read_key(context, step, body.key(i).text, value);
    }
    for (std::size_t i = 0; i < form.required; ++i)
        if (!body.find(form.keys[i]))
            context.report(Code::missing_field, word.span, fmt::format("{} needs {}", form.word, form.keys[i]));
}

void read_step(ReadContext& context, Script& script, const YamlNode& node) {
    if (node.kind != YamlKind::map || node.entries() != 1)
        return context.report(Code::not_one_key, node.span, "a step is a map with exactly one key",
                              "for example: {wait: {ticks: 500}}");
    const YamlNode& word = node.key(0);
    const YamlNode& body = node.value(0).resolved();
    const auto form = std::find_if(forms.begin(), forms.end(), [&](const StepForm& f) { return f.word == word.text; });
    if (form == forms.end()) {
        std::vector<std::string_view> words;
        for (const StepForm& f : forms) words.push_back(f.word);
        return context.report(Code::unknown_step, word.span, fmt::format("no step is called {}", word.text),
                              suggestion(word.text, words));
    }
    ScriptStep step;
    step.kind = form->kind;
    step.where = context.source.place({word.span.begin, std::max(word.span.end, body.span.end)});
    if (body.kind == YamlKind::null)
        report_missing_value(context, word, body);
    else if (form->required > 0)
        read_map(context, step, *form, word, body);
    else if (body.kind == YamlKind::scalar && !body.text.empty())
        step.name = std::string(body.text);
    else
        context.report(Code::wrong_shape, body.span, fmt::format("{} takes a single word", form->word));
    script.steps.push_back(std::move(step));
}

}  // namespace

Script read_script(const SourceText& source, const Limits& limits) {
    Script script;
    const YamlTree tree = read_yaml(source, limits);
    script.diagnostics = tree.diagnostics;
    for (Diagnostic& d : script.diagnostics)  // read_yaml() takes every file for a table
        if (d.code == entry(Code::empty_file).code)
            d = diagnose(Code::empty_file, d.where, "the file holds no steps", "begin each step with a dash");
    if (!tree.root) return script;
    const Catalog none;
    ReadContext context{source, none, limits, script.diagnostics};
    if (tree.root->kind != YamlKind::sequence) {
        context.report(Code::wrong_shape, tree.root->span, "a script is a list of steps",
                       "begin each step with a dash");
        return script;
    }
    for (const YamlNode* item : tree.root->items) {
        if (context.full()) break;
        read_step(context, script, item->resolved());
    }
    return script;
}

}  // namespace pinfield
