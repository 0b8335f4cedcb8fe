#include "engine/cli/table.h"

#include "engine/cli/command.h"
#include "engine/cli/output.h"
#include "engine/game/starts.h"
#include "engine/program/compile.h"
#include "engine/scene/catalog.h"

namespace pinfield::cli {

std::string text_of(const Diagnostics& diagnostics, const Sources& sources) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        text += format(diagnostic, sources);
        if (!text.ends_with('\n')) text += '\n';
    }
    return text;
}

Table open_table(const std::string& path, const std::vector<std::string>& outputs) {
    Reading loaded = value_or_stop(load_table(path, std::make_shared<const Catalog>(built_in_catalog())));
    for (const auto& text : loaded.scene.sources.all())
        for (const std::string& output : outputs) refuse_overwriting(output, {text->name()});
    const std::string found = text_of(loaded.diagnostics, loaded.scene.sources);
    if (!loaded.ok()) throw Stop{ExitCode::wrong, "", found};
    const auto program = compile(loaded.scene);
    if (!program) throw Stop{ExitCode::wrong, "", found + text_of(program.error(), loaded.scene.sources)};
    tell(found + text_of(doubts_of(**program, loaded.scene), loaded.scene.sources));
    return {std::move(loaded.scene), *program};
}

std::string name_of(const Scene& scene, NodeId node) { return scene.find(node) ? scene.path(node) : "table"; }

}  // namespace pinfield::cli
