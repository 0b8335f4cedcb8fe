// Unsaved work on disk, so that no crash and no kill costs an author more than the edit in hand. No window, no ImGui.
//
// One file per editing process and document, in a folder of the user's own. It is appended to: one edit, one record, and a record is the
// whole state (the text is the document, and tables are small), with its length and a checksum. A write() that was made survives the
// process; one cut short leaves a record that does not check, and the one before it counts. Replacing the file at every edit would be
// simpler still, but between two fsyncs a power cut may leave a renamed file empty, and all edits with it, where an appended one keeps
// what was synced. The first record, and now and then the last one alone when the file has grown, go to a temporary file that is renamed
// over the name.
//
// The file is locked (flock) while its editor lives: the system lets go of the lock however the process ends. Who gets the lock knows that
// the journal is orphaned; by then the name may stand for another file, so that is asked after the lock, never before it.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace pinfield::editor {

/// What would be lost.
struct UnsavedWork {
    std::string table;     ///< absolute path of its file; empty: it has none yet
    std::string base;      ///< the text as it was loaded or saved last
    std::string text;      ///< the text as it is now
    std::int64_t edits = 0;  ///< steps between both
    std::string last_label;  ///< of the last of them: "Move pop"
    std::int64_t time = 0;   ///< when it was written: seconds since 1970
    std::optional<std::string> draft{};  ///< what is typed over the text and is not it, because it does not read (yet)

    bool operator==(const UnsavedWork&) const = default;
};

/// An open file that closes, and with that unlocks, itself.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    ~Descriptor();
    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }

private:
    int number_;
};

class Journal {
public:
    /// `folder` is made (0700) with the first write. `most_bytes`: a file beyond that, and beyond eight records, is begun anew.
    explicit Journal(std::string folder, std::size_t most_bytes = 1 << 20) : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    /// From now on the journal holds this. When it fails, what it held before still counts.
    Result<void> write(const UnsavedWork& work);
    /// What is written outlasts the machine, too.
    Result<void> sync();
    /// Nothing is unsaved: the file goes.
    void drop();
    /// The file; empty while there is none.
    const std::string& path() const { return path_; }

private:
    Result<void> begin();
    Result<void> replace(const std::string& content, bool synced);
    void forget();

    std::string folder_;
    std::size_t most_bytes_;
    std::string path_;
    Descriptor file_;  ///< locked
    std::size_t size_ = 0;
    bool name_synced_ = false;
};

/// Where journals are: $XDG_STATE_HOME/pinfield, else $HOME/.local/state/pinfield. Empty where neither is set.
std::string journal_folder();

/// A journal as the bytes of its file: the head, then records.
std::string journal_head();
std::string journal_record(const UnsavedWork& work);

/// What the bytes of a journal tell: the last record that is whole.
struct JournalContent {
    enum class State : unsigned char {
        whole,       ///< `work` is what it holds
        empty,       ///< its editor died before the first write
        unreadable,  ///< no record is whole
        newer        ///< of a later Pinfield: not ours to judge
    };
    State state = State::empty;
    UnsavedWork work{};
};
JournalContent read_journal(std::string_view bytes);

/// A journal whose editor is gone.
struct Orphan {
    std::string file;
    UnsavedWork work;
};
struct Orphans {
    std::vector<Orphan> found;            ///< newest first
    std::vector<std::string> unreadable;  ///< files, sorted
};
/// The orphans in a folder. Living journals and those of later versions are left alone; what dying editors left that holds nothing is removed.
Orphans find_orphans(const std::string& folder);
/// Removes an orphan. False when it is no longer there, or in somebody's hands.
bool remove_orphan(const std::string& file);

}  // namespace pinfield::editor
