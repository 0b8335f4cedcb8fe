// A table's text -> a Scene, with everything that is wrong with it said at once.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "engine/core/diagnostic.h"
#include "engine/io/included.h"
#include "engine/io/limits.h"
#include "engine/io/yaml_tree.h"
#include "engine/scene/scene.h"

namespace pinfield {

struct ReadContext;

/// Everything one reading of a text gives: whoever edits the text goes on from here, without reading it again.
struct Reading {
    std::shared_ptr<const YamlTree> tree;  ///< of the main text
    Scene scene;                           ///< whatever could be understood, with its sources; fit for use only when ok()
    Diagnostics diagnostics;               ///< in the order of the texts
    OpenFile open{};                       ///< how the table comes to its files
    TableFiles files{};                    ///< those that it includes

    const SourceText& source() const { return scene.sources.main(); }
    bool ok() const { return !has_errors(diagnostics); }
};

/// Reads a table whose nodes are those of the catalog, and what it includes. Never throws. `open`: nothing, and the table has no folder.
Reading read_table(std::shared_ptr<const SourceText> source, std::shared_ptr<const Catalog> catalog, const Limits& limits = {}, const OpenFile& open = {});

/// Another text of the same table. The files it includes are those that `now` has read; only for further ones is the disk asked.
Reading read_again(const Reading& now, std::string text, const Limits& limits = {});
Reading read_again(const Reading& now, const std::shared_ptr<const SourceText>& text, const Limits& limits = {});

/// Makes a table's params and templates known where something that is not yet in it is read.
void know_names_of(const Reading& table, ReadContext& context);

/// The same text once more as though these params were written with these values: what moving a slider makes of the table.
Reading read_with_params(const Reading& now, const std::map<std::string, double>& values, const Limits& limits = {});

}  // namespace pinfield
