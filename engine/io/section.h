// One section of a table: how it is read, written, described to text editors and compared, in one place. THE list: sections.cpp.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "engine/io/read_context.h"
#include "engine/scene/scene.h"

namespace pinfield {

struct Section {
    std::string_view key;
    /// `key` is the section's word in the text. Null: the format has the section and this program does not, which `unsupported` says.
    void (*read)(ReadContext& context, Scene& scene, const YamlNode& key, const YamlNode& value) = nullptr;
    /// Canonical text with key and line break; empty when there is nothing to say.
    std::string (*write)(const Scene& scene) = nullptr;
    /// JSON Schema of the value, as JSON text.
    std::string (*schema)() = nullptr;
    /// Do both scenes say the same in this section, values bit for bit? Places in the text and ids do not count.
    bool (*same)(const Scene& a, const Scene& b) = nullptr;
    Code unsupported{};
    /// When it is read, wherever it stands: what gives names comes before what uses them.
    enum class Phase : unsigned char { params, templates, as_it_stands, after_nodes };
    Phase phase = Phase::as_it_stands;
};

/// In the order in which a table is written.
std::span<const Section* const> all_sections();
const Section* find_section(std::string_view key);

}  // namespace pinfield
