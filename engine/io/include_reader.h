// From `include:` to the files it names, each read once, and from those to what they include themselves.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/included.h"
#include "engine/io/read_context.h"

namespace pinfield {

/// What a path in the file `from` names, from the table's folder; or why no table may name that. Both paths have / between their words.
Result<std::string> path_below(std::string_view from, std::string_view path);

/// The files of one table while it is read.
class Inclusion {
public:
    /// `known`: what an earlier reading of this table found; only for other files is `open` asked.
    Inclusion(const SourceText& main, const YamlTree& tree, const OpenFile& open, const TableFiles& known);

    /// Reads what the list names, and puts each into the context's files behind what it includes itself.
    void read(ReadContext& context, Sources& sources, const YamlNode& list);
    TableFiles files() && { return std::move(files_); }

private:
    using File = std::shared_ptr<const TableFile>;

    void read_item(ReadContext& context, Sources& sources, const YamlNode& item);
    // Each of these tells, at the item, why not.
    bool may_ask(ReadContext& context, const YamlNode& item);
    std::optional<FoundFile> find(ReadContext& context, const YamlNode& item, const std::string& path) const;
    bool is_open(ReadContext& context, const YamlNode& item, const std::string& path) const;
    bool fits(ReadContext& context, const YamlNode& item, const FoundFile& file);

    File parsed(ReadContext& context, FoundFile found, const File& before, FileId number);
    void enter(ReadContext& context, Sources& sources, const TableFile& file);

    const OpenFile& open_;
    const TableFiles& known_;
    TableFiles files_;
    std::map<std::string, File> done_;  ///< by their own paths
    std::string folder_;                ///< of the table's own file, with the / at its end; may be empty
    std::vector<std::string> way_;      ///< to the file that is being read: the paths of those around it, the table's own first
    std::size_t asked_ = 0;             ///< paths so far, whatever was there
    std::size_t bytes_, events_;        ///< of the files so far
};

}  // namespace pinfield
