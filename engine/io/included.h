// The files that a table includes, as the reader comes to them.
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/core/source_text.h"
#include "engine/io/yaml_tree.h"

namespace pinfield {

/// A file below the table's own folder.
struct FoundFile {
    std::string path;  ///< from that folder, with / between: of one file always the same, whatever ways lead to it
    std::string text;
};

/// Opens what goes by a path from the table's own folder, and gives it all, or of a larger one the first `most` bytes. The reader has judged the path: it names nothing
/// above that folder, though links may lead there, which whoever opens it must not follow. Empty: the table has no folder.
using OpenFile = std::function<Result<FoundFile>(const std::string& path, std::size_t most)>;

/// A file that was read.
struct TableFile {
    std::string path;  ///< FoundFile's
    std::shared_ptr<const SourceText> source;
    std::shared_ptr<const YamlTree> tree;
};

/// By the path that they were asked for.
using TableFiles = std::map<std::string, std::shared_ptr<const TableFile>>;

}  // namespace pinfield
