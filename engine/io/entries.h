// Maps whose keys are few and known, such as a launch or how copies stand.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "engine/io/read_context.h"
#include "engine/reflect/node_type.h"

namespace pinfield {

/// A number that no node has as a field.
inline FieldType number_field(std::string_view key, Unit unit, Limit min, Limit max, FieldKind kind = FieldKind::number) {
    FieldMeta meta;
    meta.unit = unit;
    meta.min = min;
    meta.max = max;
    return {key, kind, meta, {}, {}, false};
}

/// Calls read(index of the key, value) for the entries that have a value, and reports keys that there are not and values that are missing.
template <class Read>
void read_entries(ReadContext& context, std::string_view what, const YamlNode& map, const std::vector<std::string_view>& keys, Read read) {
    for (std::size_t i = 0; i < map.entries() && !context.full(); ++i) {
        const auto it = std::find(keys.begin(), keys.end(), map.key(i).text);
        const YamlNode& value = map.value(i).resolved();
        if (!is_plain_key(map.key(i))) continue;
        if (it == keys.end())
            context.report(Code::unknown_key, map.key(i).span, fmt::format("{} has no {}", what, map.key(i).text),
                           suggestion(map.key(i).text, keys));
        else if (value.kind == YamlKind::null)
            report_missing_value(context, map.key(i), value);
        else
            read(it - keys.begin(), value);
    }
}

}  // namespace pinfield
