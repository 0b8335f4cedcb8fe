// What the tests of engine/io share: the catalog, tables from text, every scene file, values to try.
#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/rng.h"
#include "engine/io/same_content.h"
#include "engine/io/table_reader.h"
#include "engine/scene/catalog.h"
#include "engine/scene/edit.h"
#include "tests/places.h"

namespace pinfield::test {

inline std::shared_ptr<const Catalog> catalog() {
    static const auto shared = std::make_shared<const Catalog>(built_in_catalog());
    return shared;
}

inline Reading read(const std::string& text, const Limits& limits = {}) {
    return read_table(std::make_shared<const SourceText>("test.yaml", text), catalog(), limits);
}

/// A folder that holds these texts by their paths, and nothing else.
inline OpenFile folder_of(std::map<std::string, std::string> files) {
    return [files = std::move(files)](const std::string& path, std::size_t most) -> Result<FoundFile> {
        const auto found = files.find(path);
        if (found == files.end()) return failure("there is no " + path);
        return FoundFile{path, found->second.substr(0, most)};
    };
}

/// `main` as table.yaml beside these files.
inline Reading read_with(const std::string& main, std::map<std::string, std::string> files, const Limits& limits = {}) {
    return read_table(std::make_shared<const SourceText>("table.yaml", main), catalog(), limits, folder_of(std::move(files)));
}

inline std::string told(const Reading& result) {
    std::string out;
    for (const Diagnostic& d : result.diagnostics) out += format(d, result.scene.sources);
    return out;
}

/// "E0203 4:15" of every diagnostic.
inline std::vector<std::string> codes_and_places(const Reading& result) {
    std::vector<std::string> out;
    for (const Diagnostic& d : result.diagnostics) {
        const LineColumn at = result.scene.sources.line_column(d.where);
        out.push_back(d.code + " " + std::to_string(at.line) + ":" + std::to_string(at.column));
    }
    return out;
}

inline std::string file_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Table files of a folder of scenes/, in the order of their names.
inline std::vector<std::filesystem::path> scene_files(const std::string& folder) {
    std::vector<std::filesystem::path> out;
    const std::filesystem::path root = std::filesystem::path(test::source_dir()) / "scenes" / folder;
    if (!std::filesystem::exists(root)) return out;
    for (const auto& entry : std::filesystem::directory_iterator(root))
        if (entry.path().extension() == ".yaml") out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

/// All that is meant to be right: the shipped tables, the node examples, and one table in every style of YAML.
std::vector<std::pair<std::string, std::string>> good_tables();

/// Another value for a field, near the one it has or across its type; perhaps out of contract.
Value another_value(const FieldType& field, const Value& value, CounterRng& rng);

/// An edit of some field of some node that the scene accepts, or nothing after a few tries.
std::optional<SetField> some_edit(const Scene& scene, CounterRng& rng);

}  // namespace pinfield::test
