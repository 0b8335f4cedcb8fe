#include "engine/io/load_table.h"

#include "engine/core/error_codes.h"
#include "engine/io/files_below.h"

namespace pinfield {

OpenFile files_beside(const std::string& path) {
    const std::size_t name = path.rfind('/') + 1;  // 0 where there is none
    return [folder = path.substr(0, name)](const std::string& below, std::size_t most) { return read_below(folder, below, most); };
}

Result<Reading> load_table(const std::string& path, std::shared_ptr<const Catalog> catalog, const Limits& limits) {
    Result<FileStart> start = read_file_start(path, limits.file_bytes);
    if (!start) return tl::unexpected<Failure>(start.error());
    if (!start->whole) {
        const auto none = std::make_shared<const SourceText>(path, "");
        Reading result{std::make_shared<const YamlTree>(), Scene(std::move(catalog)), {}};
        result.scene.sources = Sources(none);
        result.diagnostics.push_back(diagnose(Code::file_too_large, none->place({0, 0}),
                                              "the file is larger than " + std::to_string(limits.file_bytes) + " bytes"));
        return result;
    }
    return read_table(std::make_shared<const SourceText>(path, std::move(start->content)), std::move(catalog), limits, files_beside(path));
}

}  // namespace pinfield
