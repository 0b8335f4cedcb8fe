#include "engine/io/script_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/io/value_reader.h"

namespace pinfield {
namespace {

using Kind = ScriptStep::Kind;

/// What a step holds behind its word: a map of keys, a word, a list of names (or one), a text of any kind.
enum class Body : unsigned char { map, word, names, text };

struct StepForm {
    std::string_view word;
    Kind kind;
    Body body;
    std::array<std::string_view, 5> keys{};  ///< of a map
    std::size_t required = 0;                ///< how many of the keys must be there
};

constexpr std::array forms{
    StepForm{"action", Kind::action, Body::word},
    StepForm{"set", Kind::set, Body::map, {"node", "field", "value"}, 3},
    StepForm{"insert", Kind::insert, Body::map, {"yaml", "parent", "index"}, 1},
    StepForm{"paste", Kind::paste, Body::text},
    StepForm{"remove", Kind::remove, Body::names},
    StepForm{"move", Kind::move, Body::map, {"node", "parent", "index"}, 1},
    StepForm{"wrap", Kind::wrap, Body::map, {"nodes", "in"}, 2},
    StepForm{"unwrap", Kind::unwrap, Body::names},
    StepForm{"rename", Kind::rename, Body::map, {"node", "id"}, 2},
    StepForm{"select", Kind::select, Body::names},
    StepForm{"click", Kind::click, Body::map, {"at", "on", "button", "times", "with"}},
    StepForm{"drag", Kind::drag, Body::map, {"from", "to", "button", "with"}, 2},
    StepForm{"scroll", Kind::scroll, Body::map, {"by", "at", "on", "with"}, 1},
    StepForm{"type", Kind::type, Body::text},
    StepForm{"key", Kind::key, Body::map, {"press", "ticks", "with"}, 1},
    StepForm{"wait", Kind::wait, Body::map, {"ticks"}, 1},
    StepForm{"screenshot", Kind::screenshot, Body::word},
    StepForm{"expect", Kind::expect, Body::map, {"node", "field", "value", "tolerance"}, 3},
};

const StepForm& form_of(Kind kind) {
    return *std::find_if(forms.begin(), forms.end(), [&](const StepForm& form) { return form.kind == kind; });
}

std::optional<Vec2> read_place(ReadContext& context, std::string_view key, const YamlNode& value) {
    FieldMeta meta;
    meta.unit = Unit::metre;
    const auto read = read_value(context, {key, FieldKind::vec2, meta, {}, {}, false}, value);
    return read ? std::optional(std::get<Vec2>(*read)) : std::nullopt;
}

std::optional<double> read_number(ReadContext& context, std::string_view key, const YamlNode& value, double least, double most) {
    FieldMeta meta;
    meta.min = from(least);
    meta.max = to(most);
    const auto read = read_value(context, {key, FieldKind::number, meta, {}, {}, false}, value);
    return read ? std::optional(std::get<double>(*read)) : std::nullopt;
}

void read_count(ReadContext& context, std::string_view key, const YamlNode& value, int& out) {
    FieldMeta meta;
    meta.min = from(0);
    meta.max = to(1e7);
    if (const auto read = read_value(context, {key, FieldKind::integer, meta, {}, {}, false}, value))
        out = static_cast<int>(std::get<std::int64_t>(*read));
}

/// [x, y] is a place on the table, a word or text words on the screen, {panel: words} words in a panel.
void read_point(ReadContext& context, std::string_view key, const YamlNode& value, ScriptPoint& out) {
    if (value.kind == YamlKind::sequence) {
        out.place = read_place(context, key, value);
    } else if (value.kind == YamlKind::scalar && key != "at") {
        out.words = std::string(value.text);
    } else if (value.kind == YamlKind::map && value.entries() == 1 && value.value(0).resolved().kind == YamlKind::scalar && key != "at") {
        out.panel = std::string(value.key(0).text);
        out.words = std::string(value.value(0).resolved().text);
    } else {
        const std::string_view words = key == "at" ? "" : ", or words on the screen";
        context.report(Code::wrong_shape, value.span, fmt::format("{} is a place: [x, y] in metres{}", key, words));
    }
}

void read_names(ReadContext& context, std::string_view key, const YamlNode& value, std::vector<std::string>& out) {
    const auto add = [&](const YamlNode& name) {
        if (name.kind == YamlKind::scalar && !name.text.empty()) return out.emplace_back(name.text), void();
        context.report(Code::wrong_shape, name.span, fmt::format("{} takes a name or a list of names", key));
    };
    if (value.kind != YamlKind::sequence) return add(value);
    for (const YamlNode* item : value.items) add(item->resolved());
}

/// A text as it stands: of a scalar what it says, of anything else its YAML.
std::string text_of(const ReadContext& context, const YamlNode& value) {
    return std::string(value.kind == YamlKind::scalar ? value.text : context.source().slice(value.span));
}

std::string* word_for(ScriptStep& step, std::string_view key) {
    if (key == "node") return &step.node;
    if (key == "field") return &step.field;
    if (key == "parent") return &step.parent;
    if (key == "button") return &step.button;
    return key == "press" || key == "in" || key == "id" ? &step.name : nullptr;
}

void read_key(ReadContext& context, ScriptStep& step, std::string_view key, const YamlNode& value) {
    if (key == "value" || key == "yaml")
        step.value = text_of(context, value);
    else if (key == "tolerance")
        step.tolerance = text_of(context, value);
    else if (key == "from" || key == "at" || key == "on")
        read_point(context, key, value, step.from);
    else if (key == "to")
        read_point(context, key, value, step.to);
    else if (key == "nodes")
        read_names(context, key, value, step.nodes);
    else if (key == "with")
        read_names(context, key, value, step.with);
    else if (key == "ticks")
        read_count(context, key, value, step.ticks);
    else if (key == "times")
        read_count(context, key, value, step.times);
    else if (key == "index")
        read_count(context, key, value, step.index);
    else if (key == "by")
        step.by = read_number(context, key, value, -1000, 1000).value_or(0);
    else if (value.kind != YamlKind::scalar)
        context.report(Code::wrong_shape, value.span, fmt::format("{} is a single word", key));
    else
        *word_for(step, key) = std::string(value.text);
}

/// What no list of keys can say.
void judge(ReadContext& context, const ScriptStep& step, const YamlNode& word) {
    const bool points = step.kind == Kind::click || step.kind == Kind::scroll;
    if (points && !step.from.place && step.from.words.empty())
        context.report(Code::missing_field, word.span, fmt::format("{} needs at or on", word.text));
    if (step.button != "left" && step.button != "right" && step.button != "middle")
        context.report(Code::wrong_shape, word.span, fmt::format("there is no button {}", step.button), "left, right or middle");
}

void read_map(ReadContext& context, ScriptStep& step, const StepForm& form, const YamlNode& word, const YamlNode& body) {
    std::vector<std::string_view> known;
    for (const std::string_view key : form.keys)
        if (!key.empty()) known.push_back(key);
    if (body.kind != YamlKind::map)
        return context.report(Code::wrong_shape, word.span, fmt::format("{} takes {}", form.word, fmt::join(known, ", ")));
    for (std::size_t i = 0; i < body.entries(); ++i) {
        const YamlNode& value = body.value(i).resolved();
        if (std::find(known.begin(), known.end(), body.key(i).text) == known.end())
            context.report(Code::unknown_key, body.key(i).span, fmt::format("{} has no {}", form.word, body.key(i).text),
                           suggestion(body.key(i).text, known));
        else if (value.kind == YamlKind::null)
            report_missing_value(context, body.key(i), value);
        else
            read_key(context, step, body.key(i).text, value);
    }
    for (std::size_t i = 0; i < form.required; ++i)
        if (!body.find(form.keys[i])) context.report(Code::missing_field, word.span, fmt::format("{} needs {}", form.word, form.keys[i]));
}

void read_step(ReadContext& context, Script& script, const YamlNode& node) {
    if (node.kind != YamlKind::map || node.entries() != 1)
        return context.report(Code::not_one_key, node.span, "a step is a map with exactly one key", "for example: {wait: {ticks: 500}}");
    const YamlNode& word = node.key(0);
    const YamlNode& body = node.value(0).resolved();
    const auto form = std::find_if(forms.begin(), forms.end(), [&](const StepForm& f) { return f.word == word.text; });
    if (form == forms.end()) {
        std::vector<std::string_view> words;
        for (const StepForm& f : forms) words.push_back(f.word);
        return context.report(Code::unknown_step, word.span, fmt::format("no step is called {}", word.text), suggestion(word.text, words));
    }
    ScriptStep step;
    step.kind = form->kind;
    step.where = context.source().place({word.span.begin, std::max(word.span.end, body.span.end)});
    if (body.kind == YamlKind::null) {
        report_missing_value(context, word, body);
    } else if (form->body == Body::map) {
        read_map(context, step, *form, word, body);
        judge(context, step, word);
    } else if (form->body == Body::names) {
        read_names(context, form->word, body, step.nodes);
    } else if (form->body == Body::text) {
        step.value = text_of(context, body);
    } else if (body.kind == YamlKind::scalar && !body.text.empty()) {
        step.name = std::string(body.text);
    } else {
        context.report(Code::wrong_shape, body.span, fmt::format("{} takes a single word", form->word));
    }
    script.steps.push_back(std::move(step));
}

}  // namespace

std::string_view word_of(Kind kind) { return form_of(kind).word; }

Script read_script(const SourceText& source, const Limits& limits) {
    Script script;
    const YamlTree tree = read_yaml(source, limits);
    script.diagnostics = tree.diagnostics;
    for (Diagnostic& d : script.diagnostics)  // read_yaml() takes every file for a table
        if (d.code == entry(Code::empty_file).code)
            d = diagnose(Code::empty_file, d.where, "the file holds no steps", "begin each step with a dash");
    if (!tree.root) return script;
    const Catalog none;
    ReadContext context{&source, none, limits, script.diagnostics};
    if (tree.root->kind != YamlKind::sequence) {
        context.report(Code::wrong_shape, tree.root->span, "a script is a list of steps", "begin each step with a dash");
        return script;
    }
    for (const YamlNode* item : tree.root->items) {
        if (context.full()) break;
        read_step(context, script, item->resolved());
    }
    return script;
}

}  // namespace pinfield
