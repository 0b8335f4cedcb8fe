// inputs: {left: [Z, LeftShift], ...}
#include <fmt/format.h>

#include "engine/core/keys.h"
#include "engine/io/node_writer.h"
#include "engine/io/schema_parts.h"
#include "engine/io/section.h"
#include "engine/io/value_writer.h"
#include "engine/scene/validate.h"

namespace pinfield::sections {
namespace {

void read_binding(ReadContext& context, Scene& scene, const YamlNode& key, const YamlNode& value) {
    if (!is_plain_key(key)) return;
    if (!is_name(key.text))
        return context.report(Code::bad_name, key.span, fmt::format("{} is not a valid name for an input", key.text),
                              "small letters, digits and _");
    if (value.kind == YamlKind::null) return report_missing_value(context, key, value);
    InputBinding binding{std::string(key.text), {}, context.source().place({key.span.begin, value.span.end})};
    std::vector<const YamlNode*> items{&value};
    if (value.kind == YamlKind::sequence) items.assign(value.items.begin(), value.items.end());
    for (const YamlNode* item : items) {
        if (context.full()) return;
        const YamlNode& name = item->resolved();
        if (name.kind != YamlKind::scalar || name.text.empty()) {
            context.report(Code::wrong_shape, name.span, "the name of a key is due here");
            continue;
        }
        if (key_code(name.text) < 0) {
            std::vector<std::string_view> known;
            for (const KeyboardKey& known_key : keyboard_keys()) known.push_back(known_key.name);
            context.report(Code::unknown_keyboard_key, name.span,
                           fmt::format("no key of a keyboard is called {}", name.text), suggestion(name.text, known));
        }
        binding.keys.emplace_back(name.text);
    }
    scene.inputs.push_back(std::move(binding));
}

void read(ReadContext& context, Scene& scene, const YamlNode&, const YamlNode& section) {
    if (section.is_empty()) return;
    if (section.kind != YamlKind::map)
        return context.report(Code::wrong_shape, section.span, "inputs are due here",
                              "write inputs: {left: [Z, LeftShift]}");
    for (std::size_t i = 0; i < section.entries() && !context.full(); ++i)
        read_binding(context, scene, section.key(i), section.value(i).resolved());
}

std::string write(const Scene& scene) {
    std::vector<std::string> entries;
    for (const InputBinding& input : scene.inputs)
        if (!is_elsewhere(scene, input.where)) entries.push_back(entry_of(input));
    return entries.empty() ? std::string() : fmt::format("inputs: {}\n", flow_map(entries));
}

bool same(const Scene& a, const Scene& b) {
    return std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(), same_input);
}

}  // namespace
}  // namespace pinfield::sections

namespace pinfield {

std::string keys_text(const std::vector<std::string>& keys) {
    std::vector<std::string> out;
    for (const std::string& key : keys) out.push_back(write_text(key));
    return fmt::format("[{}]", fmt::join(out, ", "));
}

std::string entry_of(const InputBinding& input) { return fmt::format("{}: {}", input.name, keys_text(input.keys)); }

}  // namespace pinfield

namespace pinfield::sections {

extern const Section inputs{
    .key = "inputs",
    .read = read,
    .write = write,
    .schema = [] { return schema::named_map(schema::one_or_list(R"({"type": ["string", "integer"]})")); },
    .same = same,
};

}  // namespace pinfield::sections
