// What every part of the reader is handed: the text, the catalog, the limits, and the list that findings go to.
#pragma once
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/closest.h"
#include "engine/core/error_codes.h"
#include "engine/io/limits.h"
#include "engine/io/names.h"
#include "engine/io/yaml_tree.h"
#include "engine/reflect/catalog.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// A template as the text has it, read anew wherever it is used.
struct TemplateText {
    const YamlNode* key = nullptr;
    const YamlNode* args = nullptr;   ///< a map; null: it takes none
    const YamlNode* nodes = nullptr;  ///< a list; null: what is there has been found wrong
    const SourceText* text = nullptr;  ///< that it stands in
    bool is_used = false;
};

/// One of a table's files.
struct TableText {
    const SourceText* text;
    const YamlNode* root;  ///< a map
};

class Inclusion;

struct ReadContext {
    const SourceText* text;  ///< that what is being read stands in: one of the table's files
    const Catalog& catalog;
    const Limits& limits;
    Diagnostics& diagnostics;
    const std::map<std::string, double>* set_params = nullptr;  ///< values of params in place of what the text says
    WrittenParts written{};  ///< parts of the value that is being read which are expressions or $names
    int parts_read = 0;      ///< numbers and words of that value, so far
    Names table_names{};           ///< the params
    const Names* names = nullptr;  ///< what names mean where the value stands; null: there are none
    std::map<std::string_view, TemplateText> templates{};
    std::map<std::string_view, Place> materials{};  ///< so far
    Inclusion* inclusion = nullptr;                 ///< null: nothing can be included here
    std::vector<TableText> files{};                 ///< of the table: each behind what it includes, its own last
    std::shared_ptr<const Origin> origin{};  ///< of the nodes that are being read
    std::string id_prefix{}, id_suffix{};    ///< around the ids that they have in the text
    std::vector<std::string_view> open_templates{};  ///< whose nodes are being read, the outermost first
    std::size_t nodes_made = 0, depth = 0;           ///< so far; of the list of nodes that is being read
    bool is_exhausted = false;                       ///< a limit of the whole is reached
    std::size_t failures = 0;  ///< of which nothing is said that was not said before

    const SourceText& source() const { return *text; }
    void report(Diagnostic found) {
        for (auto step = origin; step; step = step->outer) found.via.push_back({step->what, step->where});
        if (!found.via.empty() && is_said(found)) return fail_silently();
        if (diagnostics.size() < limits.errors)
            diagnostics.push_back(std::move(found));
        else if (diagnostics.size() == limits.errors)
            diagnostics.push_back(diagnose(Code::too_many_errors, found.where, std::string(more_errors_follow)));
    }
    void report(Code code, Span where, std::string message, std::string hint = {}) {
        report(diagnose(code, source().place(where), std::move(message), std::move(hint)));
    }
    void fail_silently() { ++failures; }
    /// So much is wrong that the rest is not worth reading: whoever goes through a list asks before each item, so that
    /// neither nodes nor suggestions are made that nobody will see.
    bool full() const { return is_exhausted || diagnostics.size() > limits.errors; }
    std::size_t errors_so_far() const { return diagnostics.size() + failures; }

private:
    /// Of a template, the first use tells what is wrong in it.
    bool is_said(const Diagnostic& found) const {
        return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& said) {
            return said.code == found.code && said.where == found.where && said.message == found.message;
        });
    }
};

/// While it lives, what is read stands in this text.
class InText {
public:
    InText(ReadContext& context, const SourceText* text) : context_(context), before_(std::exchange(context.text, text)) {}
    ~InText() { context_.text = before_; }
    InText(const InText&) = delete;
    InText& operator=(const InText&) = delete;

private:
    ReadContext& context_;
    const SourceText* before_;
};

/// False for the keys that read_yaml() has reported already: lists, maps, null and <<.
inline bool is_plain_key(const YamlNode& key) { return key.kind == YamlKind::scalar && key.text != "<<"; }

/// Reports a key whose value is missing, with the reason where a comment swallowed it.
void report_missing_value(ReadContext& context, const YamlNode& key, const YamlNode& value);

/// True (and reported) when a value holds an opening bracket that its comma-separated neighbour closes.
bool report_comma_split(ReadContext& context, const YamlNode& value);

}  // namespace pinfield
