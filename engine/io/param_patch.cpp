#include "engine/io/param_patch.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/io/entries.h"
#include "engine/io/field_patch.h"
#include "engine/io/quantity.h"
#include "engine/io/same_content.h"
#include "engine/io/value_writer.h"
#include "engine/io/yaml_edit.h"
#include "engine/scene/elsewhere.h"

namespace pinfield {
namespace {

const Param* find_param(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.params.begin(), scene.params.end(), [&](const Param& param) { return param.name == name; });
    return found == scene.params.end() ? nullptr : &*found;
}

Failure failure_of(const Reading& reading) {
    for (const Diagnostic& d : reading.diagnostics)
        if (d.severity == Severity::error)
            return {fmt::format("line {}: {}", reading.scene.sources.line_column(d.where).line, d.message)};
    return {"the table cannot be read with it"};
}

void take_ids(Scene& scene, const Scene& from) {
    if (scene.all().size() == from.all().size()) scene.take_ids_of(from);
    else scene.keep_ids_of(from);
}

}  // namespace

std::optional<std::string> why_not_set(const Scene& scene, const std::string& name, double value) {
    const Param* param = find_param(scene, name);
    if (!param) return fmt::format("no param is called {}", name);
    if (auto why = why_elsewhere(scene, name, param->where)) return why;
    if (param->is_calculated) return fmt::format("{} follows `{}`: change it in the text", name, param->value.text);
    if (param->min && value < param->min->value) return fmt::format("{} is at least {}", name, param->min->text);
    if (param->max && value > param->max->value) return fmt::format("{} is at most {}", name, param->max->text);
    return {};
}

Result<Scene> scene_with_param(const Reading& now, const std::string& name, double value, const Limits& limits) {
    if (const auto why = why_not_set(now.scene, name, value)) return failure(*why);
    Reading set = read_with_params(now, {{name, value}}, limits);
    if (!set.ok()) return tl::unexpected(failure_of(set));
    take_ids(set.scene, now.scene);
    return std::move(set.scene);
}

Result<PatchedText> patch_param(const Reading& now, const std::string& name, double value, const Limits& limits) {
    const Result<Scene> expected = scene_with_param(now, name, value, limits);
    if (!expected) return tl::unexpected(expected.error());
    const Param& param = *find_param(now.scene, name);
    const YamlNode* written = node_at(*now.tree, param.value_where.span);
    if (!written) return failure("the text does not hold the param");
    if (const YamlNode* shared = shared_above(written)) return tl::unexpected(shared_failure(*shared));
    const FieldType number = number_field("value", unit_of(param.dimension), {}, {});
    const TextPatch patch{param.value_where, write_number_like(number, value, written)};
    PatchedText out{{patch}, read_again(now, apply(patch, now.source().text()), limits), 1};
    if (!out.reading.ok()) return tl::unexpected(failure_of(out.reading));
    if (!same_content(out.reading.scene, *expected)) return failure("the text would change more than this value");
    out.reading.scene.take_ids_of(*expected);
    return out;
}

}  // namespace pinfield
