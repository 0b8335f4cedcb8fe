// What is typed into the table's text by hand: it becomes the document's once it reads; until then it is kept here, and the document is
// as it was. No window.
#pragma once
#include <memory>
#include <vector>

#include "editor/document.h"
#include "editor/splice.h"

namespace pinfield::editor {

class SourceDraft {
public:
    /// Typing that rests for so many seconds is read: digits on their way to a number are not yet what the author means.
    static constexpr double pause = 0.25;

    /// The text to show: what is typed, else the document's.
    const std::shared_ptr<const SourceText>& text(const Document& document) const {
        return text_ ? text_ : document.scene().sources.shared_main();
    }
    /// The text that the document does not have, or null.
    const std::shared_ptr<const SourceText>& pending_text() const { return text_; }
    /// Is there a text that the document does not have?
    bool pending() const { return text_ != nullptr; }
    /// Has it not been read since it was typed?
    bool waiting() const { return waiting_; }
    /// The document has changed since this was begun: it waits for try_again() or discard().
    bool stale(const Document& document) const;
    /// What is wrong with the pending text as it was read last, at the places where that stands now in diagnosed().
    const Diagnostics& problems() const { return problems_; }
    const Sources& diagnosed() const { return diagnosed_; }

    void type(Document& document, const Splice& splice);
    /// Counts the rest that typing takes, and reads when that was long enough: once a frame.
    void pass(Document& document, double seconds);
    /// Reads at once what is waiting. A text that reads becomes a step of the history; typing that goes on where it ended joins that step.
    void read(Document& document);
    /// Takes the last typing back, or forward again, as long as the text is pending; false when there is none. Characters typed one behind
    /// the other without a rest go together.
    bool undo(Document& document);
    bool redo(Document& document);
    /// Where the last typing, or its undo, ended.
    std::size_t place() const { return place_; }

    /// Goes on with a text that was typed over the document's in another editor.
    void restore(Document& document, const std::string& typed);
    void discard();
    /// Reads the text once more over the document as it is now: with what changed there where both can be had, else as it is.
    void try_again(Document& document);

private:
    void begin(const Document& document, const Splice& splice);
    void put(const Document& document, const Splice& splice);
    void forget();

    std::shared_ptr<const SourceText> text_;  ///< null: the document's own
    std::shared_ptr<const SourceText> base_;  ///< the document's when typing began
    Diagnostics problems_;
    Sources diagnosed_;
    bool waiting_ = false;
    double rest_ = 0;  ///< seconds
    std::size_t place_ = 0;
    std::vector<Splice> typed_;  ///< each as what takes it back, or, behind position_, forward again
    std::size_t position_ = 0;
    bool goes_on_ = false;                    ///< with the step before
    std::shared_ptr<const SourceText> left_;  ///< the document's as the last step here left it
    std::size_t left_place_ = 0;
};

}  // namespace pinfield::editor
