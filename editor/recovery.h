// Unsaved work that is kept while it is edited, and offered after its editor has died. No window, no ImGui.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "editor/document.h"
#include "editor/journal.h"
#include "editor/line_diff.h"

namespace pinfield::editor {

/// Keeps a journal of whatever document it is shown: writes what changed at once, syncs it at most every two seconds, and drops it when
/// nothing is unsaved. A journal that cannot be written is said to be so once, and tried again now and then.
class WorkKeeper {
public:
    explicit WorkKeeper(std::string folder) : folder_(folder), journal_(std::move(folder)) {}

    /// Once a frame. `draft`: what is typed and is not the document's; null: nothing. `now`: seconds since some start. A sentence for the user, when there is something to say.
    std::optional<std::string> follow(const Document& document, double now, const std::shared_ptr<const SourceText>& draft = {});
    /// Before the process ends with work unsaved. Whether the journal, on the disk, holds all that follow() was shown.
    bool sync();
    /// The user wants none of it.
    void drop();
    const std::string& folder() const { return folder_; }
    const std::string& path() const { return journal_.path(); }

private:
    bool follows(const Document& document, const std::shared_ptr<const SourceText>& draft) const;

    std::string folder_;
    Journal journal_;
    std::shared_ptr<const SourceText> text_, draft_;  ///< last seen
    std::string table_, base_;                ///< likewise
    bool due_ = false, unsynced_ = false, failing_ = false;
    double retry_at_ = 0, sync_at_ = 0;
};

/// A document's unsaved work, as of now, with what is typed and not yet its text.
UnsavedWork unsaved_work(const Document& document, const std::shared_ptr<const SourceText>& draft = {});
/// The path that journals know a file by: absolute, without symbolic links.
std::string table_path(const std::string& path);

/// Unsaved work that is offered to the user.
struct Recovery {
    Orphan orphan;
    bool file_changed = false;  ///< the file holds something else than the work began with
    bool file_gone = false;
    LineDiff diff{};            ///< from the document to the work, and what is typed over that
};
Recovery recovery_of(Orphan orphan, const Document& document);
/// "table.yaml: 12 edits since the last save, 5 minutes ago; the last one: Move pop." `now`: seconds since 1970.
std::string summary(const Recovery& recovery, std::int64_t now);
std::int64_t seconds_since_1970();

}  // namespace pinfield::editor
