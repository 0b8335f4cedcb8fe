// The author's file while it is edited: text, scene, history, disk. No window, no ImGui.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/diagnostic.h"
#include "engine/core/result.h"
#include "engine/core/source_text.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

namespace pinfield::editor {

/// What changed in the scene since somebody last asked: one field each, or everything.
struct SceneChange {
    bool everything = false;
    NodeId node;
    int field = 0;
};

/// What became of the file on disk.
enum class DiskState : unsigned char { same, reloaded, broken, conflict };

class Document {
public:
    /// A new, unsaved table from a starter text.
    static Document untitled(std::shared_ptr<const Catalogue> catalogue);
    /// Fails when the file cannot be read. A file with errors opens: diagnostics() says what is wrong, scene() is what could be understood.
    static Result<Document> open(const std::string& path, std::shared_ptr<const Catalogue> catalogue);

    const SourceText& source() const { return *source_; }
    const Scene& scene() const { return *scene_; }
    const Diagnostics& diagnostics() const { return diagnostics_; }
    const std::string& path() const { return path_; }  ///< empty: never saved
    bool dirty() const;                                ///< the text differs from the disk's as last seen

    /// Shows an edit without writing it: the scene changes, the text does not (a drag in progress). Several previews of one
    /// field replace each other; several fields may be previewed together. Why not, or nothing.
    std::optional<std::string> preview(const Edit& edit);
    /// Turns what is previewed into one text patch each and one undo step. `label` names the step ("Move pop").
    std::optional<std::string> commit(const std::string& label);
    /// Takes the preview back (Esc during a drag).
    void cancel_preview();
    bool previewing() const { return !preview_.empty(); }
    /// preview() and commit() in one.
    std::optional<std::string> edit(const Edit& edit, const std::string& label);

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ < history_.size(); }
    void undo();
    void redo();
    const std::string* undo_label() const;
    const std::string* redo_label() const;

    /// Atomic; refuses when the disk no longer holds what was loaded or saved last.
    Result<void> save();
    Result<void> save_as(const std::string& path);
    /// Looks at the disk: a clean document follows it (broken text keeps the last good scene and shows its problems);
    /// a dirty one whose file changed outside reports a conflict and changes nothing.
    DiskState check_disk();

    /// Scene changes since the last call, for the running table.
    std::vector<SceneChange> take_changes();

private:
    struct Step {
        std::string label;
        std::vector<Edit> forward, backward;
        std::string text_before, text_after;
    };

    Document() = default;
    void adopt(std::shared_ptr<const SourceText> source, bool keep_ids);
    void replay(const std::vector<Edit>& edits, const std::string& text);

    std::shared_ptr<const Catalogue> catalogue_;
    std::shared_ptr<const SourceText> source_;
    std::shared_ptr<Scene> scene_;
    Diagnostics diagnostics_;
    std::string path_;
    std::string disk_text_;
    std::vector<Step> history_;
    std::size_t position_ = 0;
    std::vector<Edit> preview_, preview_inverse_;
    std::vector<SceneChange> changes_;
};

}  // namespace pinfield::editor
