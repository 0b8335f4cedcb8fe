// One section of a table: how it is read, written, described to text editors and compared, in one place. THE list: sections.cpp.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "engine/io/read_context.h"
#include "engine/scene/scene.h"

namespace pinfield {

/// A section as one of the table's files has it.
struct SectionText {
    const SourceText* text;
    const YamlNode* value;
};

struct Section {
    std::string_view key;
    /// `key` is the section's word in the text. Null: the format has the section and this program does not, which `unsupported` says.
    void (*read)(ReadContext& context, Scene& scene, const YamlNode& key, const YamlNode& value) = nullptr;
    /// In place of `read`, for what the files say only together: it is given the section of each, in their order.
    void (*read_all)(ReadContext& context, Scene& scene, std::span<const SectionText> texts) = nullptr;
    /// Canonical text with key and line break; empty when there is nothing to say.
    std::string (*write)(const Scene& scene) = nullptr;
    /// JSON Schema of the value, as JSON text.
    std::string (*schema)() = nullptr;
    /// Do both scenes say the same in this section, values bit for bit? Places in the text and ids do not count.
    bool (*same)(const Scene& a, const Scene& b) = nullptr;
    Code unsupported{};
    /// When it is read, wherever it stands: what gives names comes before what uses them.
    enum class Phase : unsigned char { includes, params, templates, as_it_stands, after_nodes };
    Phase phase = Phase::as_it_stands;
    /// Why only the table's own file may have it; empty: what the table includes may, too.
    std::string_view why_not_included{};
};

/// In the order in which a table is written.
std::span<const Section* const> all_sections();
const Section* find_section(std::string_view key);

/// Does it stand in a file that the table includes? Then the table's own text does not say it once more.
inline bool is_elsewhere(const Scene& scene, const Place& place) { return !scene.includes.empty() && is_included(place); }

}  // namespace pinfield
