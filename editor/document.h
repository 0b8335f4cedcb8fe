// The author's file while it is edited: text, scene, history, disk. No window, no ImGui.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/scene_change.h"
#include "engine/core/diagnostic.h"
#include "engine/core/result.h"
#include "engine/io/merge_text.h"
#include "engine/io/table_reader.h"
#include "engine/io/value_home.h"
#include "engine/scene/edit.h"

namespace pinfield::editor {

/// What became of the file on disk.
enum class DiskState : unsigned char { same, reloaded, merged, broken, conflict, missing };

/// The file was changed while the document was edited, and the two versions do not go together of themselves.
struct DiskMerge {
    std::string disk;                       ///< the file's text
    std::shared_ptr<const SourceText> ours; ///< the document's
    std::vector<ToldConflict> conflicts;
    std::string refusal;                    ///< not empty: there is no merged text, one version can be taken whole
};

/// Fields that were to be set and whose text stands for other places of the file, too.
struct SharedEdit {
    std::vector<SetField> fields;
    std::string label;   ///< "Change pop"
    std::string anchor;  ///< the first that is shared, by the anchor's name
    int places = 0;      ///< that it stands for, this one included
};
enum class SharedAnswer : unsigned char { everywhere, here };

/// A field whose value does not stand at its node was to be set, and nobody has said yet where such values go.
struct HomeQuestion {
    SetField edit;
    std::vector<ValueHome> homes;  ///< where it may be
};

class Document {
public:
    /// A new, unsaved table from a starter text.
    static Document untitled(std::shared_ptr<const Catalog> catalog, std::string_view text);
    /// Fails when the file cannot be read. A file with errors opens: diagnostics() says what is wrong, scene() is what could be understood.
    static Result<Document> open(const std::string& path, std::shared_ptr<const Catalog> catalog);

    const SourceText& source() const { return reading_->source(); }
    const Scene& scene() const { return previewed_ ? *previewed_ : reading_->scene; }
    /// Of the text as it is, without what is previewed.
    const Reading& reading() const { return *reading_; }
    /// What is wrong in diagnosed(): the file as it was opened, or, while the disk holds a broken text, that text.
    const Diagnostics& diagnostics() const { return (broken_ ? broken_ : reading_)->diagnostics; }
    const Sources& diagnosed() const { return (broken_ ? broken_ : reading_)->scene.sources; }
    const std::string& path() const { return path_; }  ///< empty: never saved
    /// That, and the files it includes; none for one that was never saved.
    std::vector<std::string> files() const;
    bool dirty() const;                                ///< the text differs from the disk's as last seen, or its file is gone
    /// What the text was when it was loaded or saved last.
    const std::string& saved_text() const { return disk_text_; }
    /// Steps of the history between that and the text as it is.
    std::size_t unsaved_steps() const;

    /// Shows an edit without writing it: the scene changes, the text does not (a drag in progress). Several previews of one
    /// field replace each other; several fields may be previewed together. A value that stands elsewhere is changed there, where that is known
    /// (edit_home()). Why not, or nothing.
    std::optional<std::string> preview(const SetField& edit);
    /// Why preview() would refuse it, as far as its field and node say.
    std::optional<std::string> why_not(const SetField& edit) const;
    /// Turns what is previewed into text patches and one undo step, for one reading of the text. `label` names the step ("Move pop"). When a patch is
    /// refused the preview is taken back and the reason returned. A preview that came back to where it began leaves no step.
    std::optional<std::string> commit(const std::string& label);
    /// The same of a param's number (a slider in motion): the scene is as though the text said it. Other previews are taken back.
    std::optional<std::string> preview_param(const std::string& name, double value);
    /// Takes the preview back (Esc during a drag).
    void cancel_preview();
    bool previewing() const { return previewed_ != nullptr; }
    /// preview() and commit() in one.
    std::optional<std::string> edit(const SetField& edit, const std::string& label);
    /// Any edits, one after the other, as one undo step. Why not, or nothing; then nothing has changed.
    std::optional<std::string> edit(std::span<const Edit> edits, const std::string& label);
    /// What was refused last because its text is shared, once.
    std::optional<SharedEdit> take_shared_edit();
    /// Does it all the same: at the anchor, for all places; or here alone, where what is shared is written out. As one step. Why not, or
    /// nothing.
    std::optional<std::string> edit_shared(const SharedEdit& edit, SharedAnswer answer);
    /// What was refused last because nobody knows where to write it, once.
    std::optional<HomeQuestion> take_home_question();
    /// Writes it there, as one step. Params, arguments and lines of templates are remembered: what may go there goes there from now on, without
    /// a question. Why not, or nothing.
    std::optional<std::string> edit_home(const SetField& edit, const ValueHome& home, const std::string& label);
    bool remembers_homes() const { return !homes_.empty(); }
    void forget_homes() { homes_.clear(); }
    /// Takes what was made of reading(), as one step. Why it was not made, or nothing.
    std::optional<std::string> take_patched(Result<PatchedText> patched, const std::string& label);
    /// A text as though it were this document's, with what it includes as the disk has it.
    Reading read(std::string text) const;
    /// Takes what read() gave in place of the text, as one step; it must be ok(). False, and no step, where the text is the same.
    bool replace_text(Reading reading, const std::string& label);

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ < history_.size(); }
    /// While something is previewed, either one only takes the preview back.
    void undo();
    void redo();
    std::size_t undo_steps() const { return position_; }
    /// The history: steps that are done, then those that were undone.
    std::size_t steps() const { return history_.size(); }
    const std::string& step_label(std::size_t step) const { return history_[step].label; }
    /// How many steps were done when the text was the disk's; nothing where no number of steps leads there.
    std::optional<std::size_t> saved_after() const;
    /// Undoes or redoes until so many steps are done.
    void go_to(std::size_t done);
    const std::string* undo_label() const;
    /// Makes the last two steps one, under the first one's name: a copy, and where it was dragged to. None is left of two that lead back to
    /// where the first began.
    void join_steps();
    const std::string* redo_label() const;

    /// Atomic; refuses when the disk no longer holds what was loaded or saved last.
    Result<void> save();
    /// Atomic; overwrites what is there: who names a path has been asked.
    Result<void> save_as(const std::string& path);
    /// Looks at the disk: a clean document follows it (broken text keeps the last good scene and shows its problems);
    /// a dirty one whose file changed outside is merged with it, as one step; where both touched the same, and where the disk's text does
    /// not read, it reports a conflict and changes nothing. A file that two looks in a row do not find is missing: the document is all that
    /// is left of it.
    /// When a file that the table includes has changed, the table is read with it as it is now; the text stays, and there is no step.
    DiskState check_disk();
    /// What check_disk() found in conflict; null: nothing, or a text that does not read.
    const std::shared_ptr<const DiskMerge>& disk_merge() const { return disk_merge_; }
    /// Merges the document with its file as it was chosen, or takes one version whole, as one step. Why not, or nothing.
    std::optional<std::string> merge_disk(const Choices& choices);
    std::optional<std::string> settle_disk(Whose whole);
    /// How many comments the last merge left out.
    int comments_left_out() const { return comments_left_out_; }
    /// Takes the disk's text in place of the document's, whatever was edited; undo brings it back. Fails on a broken text.
    Result<void> reload();
    /// Takes unsaved work that was kept elsewhere in place of the text, as one step that counts as the `steps` it was made in. The disk is
    /// left alone: the document is dirty then.
    void restore(std::string text, std::size_t steps);

    /// Scene changes since the last call, for the running table.
    std::vector<SceneChange> take_changes();

private:
    /// Ids say which node of one text is which of the other, in the order of Scene::all().
    struct Step {
        std::string label;
        std::shared_ptr<const SourceText> source_before, source_after;
        std::vector<NodeId> ids_before, ids_after;
        std::vector<SceneChange> changes;
    };

    Document() = default;
    bool is_missing() const { return looks_without_file_ >= 2; }
    std::shared_ptr<const SourceText> named(std::string text) const;
    const std::shared_ptr<const SourceText>& shared_source() const { return reading_->scene.sources.shared_main(); }
    void take(Reading reading, const Scene* ids_from);
    std::optional<std::string> write(std::span<const Edit> edits, const std::string& label);
    void replay(const Step& step, const std::shared_ptr<const SourceText>& source, const std::vector<NodeId>& ids);
    void follow_disk(Reading reading);
    DiskState follow_included();
    void agree_with_disk();
    void note_shared(std::span<const Edit> edits, const std::string& label);
    std::optional<std::string> commit_param(const std::string& label);
    std::optional<std::string> preview_home(const SetField& edit);
    std::optional<ValueHome> known_home(const std::vector<ValueHome>& homes) const;
    Result<Reading> with_previews(const std::vector<SetField>& edits) const;
    void show_instead(Scene scene);
    void put(Reading reading, const std::string& label, bool whole, bool has_ids = false);
    Reading saved_reading() const;
    DiskState follow_dirty(std::string disk);
    void take_merged(Reading reading, std::string disk);
    void push(Step step);

    std::shared_ptr<const Catalog> catalog_;
    std::shared_ptr<const Reading> reading_;  ///< of the text as it is
    std::shared_ptr<const Reading> broken_;   ///< of what the disk holds when that cannot be used
    std::string path_;
    std::string disk_text_;
    std::vector<NodeId> disk_ids_;  ///< of its nodes
    std::shared_ptr<const DiskMerge> disk_merge_;
    int comments_left_out_ = 0;
    int looks_without_file_ = 0;  ///< in a row
    std::vector<Step> history_;
    std::size_t position_ = 0;
    std::size_t saved_position_ = 0;  ///< where the text was the disk's; where the history has left that way, where it did
    std::size_t lost_steps_ = 0;      ///< between there and the disk's text
    std::optional<SharedEdit> shared_edit_;
    /// A param and the value it is shown at.
    struct ParamPreview {
        std::string name;
        double value = 0;
    };
    std::vector<SetField> preview_;
    std::optional<ParamPreview> param_preview_;
    std::optional<Reading> home_preview_;  ///< of the text that says what is previewed, where some of it stands elsewhere
    std::vector<ValueHome> homes_;         ///< that were chosen, the last one last
    std::optional<HomeQuestion> home_question_;
    std::shared_ptr<Scene> previewed_;  ///< the scene with what is previewed; null when nothing is
    std::vector<SceneChange> changes_;
};

}  // namespace pinfield::editor
