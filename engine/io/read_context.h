// What every part of the reader is handed: the text, the catalog, the limits, and the list that findings go to.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/closest.h"
#include "engine/core/error_codes.h"
#include "engine/io/limits.h"
#include "engine/io/yaml_tree.h"
#include "engine/reflect/catalog.h"
#include "engine/scene/scene.h"

namespace pinfield {

struct ReadContext {
    const SourceText& source;
    const Catalog& catalog;
    const Limits& limits;
    Diagnostics& diagnostics;
    WrittenNumbers written{};  ///< numbers of the value that is being read which are expressions
    int numbers_read = 0;      ///< of that value, so far

    void report(Diagnostic found) {
        if (diagnostics.size() < limits.errors)
            diagnostics.push_back(std::move(found));
        else if (diagnostics.size() == limits.errors)
            diagnostics.push_back(diagnose(Code::too_many_errors, found.where, std::string(more_errors_follow)));
    }
    void report(Code code, Span where, std::string message, std::string hint = {}) {
        report(diagnose(code, source.place(where), std::move(message), std::move(hint)));
    }
    /// So much is wrong that the rest is not worth reading: whoever goes through a list asks before each item, so that
    /// neither nodes nor suggestions are made that nobody will see.
    bool full() const { return diagnostics.size() > limits.errors; }
    std::size_t errors_so_far() const { return diagnostics.size(); }
};

/// False for the keys that read_yaml() has reported already: lists, maps, null and <<.
inline bool is_plain_key(const YamlNode& key) { return key.kind == YamlKind::scalar && key.text != "<<"; }

/// Reports a key whose value is missing, with the reason where a comment swallowed it.
void report_missing_value(ReadContext& context, const YamlNode& key, const YamlNode& value);

/// True (and reported) when a value holds an opening bracket that its comma-separated neighbour closes.
bool report_comma_split(ReadContext& context, const YamlNode& value);

}  // namespace pinfield
