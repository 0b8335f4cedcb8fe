#include "editor/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/core/hash.h"

namespace pinfield::editor {
namespace {

namespace fs = std::filesystem;

constexpr int version = 2;  // 1 knew no drafts
constexpr std::string_view head_word = "pinfield journal ";
constexpr std::string_view record_word = "record ";
constexpr std::string_view ending = ".journal";
constexpr std::string_view temporary_ending = ".tmp";
constexpr std::size_t digits = 16;
constexpr std::size_t most_read = std::size_t{1} << 30;
constexpr std::size_t records_kept = 8;

tl::unexpected<Failure> refused(const std::string& path) {
    return failure(fmt::format("cannot keep a journal in {}: {}", path, std::strerror(errno)));
}

bool write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        content.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

std::optional<std::string> read_all(int descriptor) {
    std::string content;
    char buffer[1 << 16];
    while (content.size() <= most_read) {
        const ssize_t count = ::read(descriptor, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        if (count == 0) return content;
        content.append(buffer, static_cast<std::size_t>(count));
    }
    return std::nullopt;
}

/// Every folder on the way that is not there is the user's alone.
bool make_folder(const fs::path& folder) {
    std::error_code unknown;
    if (folder.empty() || fs::is_directory(folder, unknown)) return true;
    return make_folder(folder.parent_path()) && (::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST);
}

bool lock(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

/// Whether an open file is still what its name stands for.
bool is_at(int descriptor, const std::string& path) {
    struct stat open {}, named {};
    return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

std::string temporary_of(const std::string& path) { return path + std::string(temporary_ending); }

/// The file, locked and at its name; or nothing: it lives, it is gone, it is no file of ours.
Descriptor take_orphan(const std::string& path) {
    Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    struct stat status {};
    const bool ours = file && ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
    return ours && lock(file.number()) && is_at(file.number(), path) ? std::move(file) : Descriptor();
}

/// Takes numbers and texts off the front of a record.
class Cursor {
public:
    explicit Cursor(std::string_view rest) : rest_(rest) {}
    bool failed() const { return failed_; }
    bool at_end() const { return rest_.empty(); }
    std::string_view take(std::size_t count) {
        if (count > rest_.size()) failed_ = true;
        const std::string_view taken = failed_ ? std::string_view() : rest_.substr(0, count);
        rest_.remove_prefix(taken.size());
        return taken;
    }
    std::uint64_t number() {
        const std::string_view text = take(digits);
        std::uint64_t x = 0;
        std::from_chars(text.data(), text.data() + text.size(), x, 16);
        if (hex16(x) != text) failed_ = true;  // one spelling only, so that no bit can be flipped unnoticed
        return x;
    }
    std::string text() { return std::string(take(number())); }

private:
    std::string_view rest_;
    bool failed_ = false;
};

std::string counted(const std::string& text) { return hex16(text.size()) + text; }

struct Record {
    std::optional<UnsavedWork> work;
    std::size_t length = 0;
};

/// The record that begins here, if it is whole.
Record record_at(std::string_view bytes) {
    Cursor cursor(bytes);
    if (cursor.take(record_word.size()) != record_word) return {};
    const std::uint64_t length = cursor.number(), checksum = cursor.number();
    const std::string_view payload = cursor.take(length);
    if (cursor.failed() || Hash64().feed(payload).value() != checksum) return {};
    Cursor fields(payload);
    UnsavedWork work;
    work.edits = static_cast<std::int64_t>(fields.number());
    work.time = static_cast<std::int64_t>(fields.number());
    for (std::string* text : {&work.table, &work.last_label, &work.base, &work.text}) *text = fields.text();
    if (!fields.at_end()) work.draft = fields.text();
    if (fields.failed() || !fields.at_end()) return {};
    return {std::move(work), record_word.size() + 2 * digits + payload.size()};
}

/// Removes the temporary files of editors that died between making one and renaming it.
void remove_temporaries(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const std::string journal = name.substr(0, name.size() - temporary_ending.size());
        struct stat status {};
        const bool owned = ::lstat(journal.c_str(), &status) == 0;  // the name is there as long as its editor lives
        if (!owned || take_orphan(journal)) ::unlink(name.c_str());
    }
}

void look_at(const std::string& path, Orphans& orphans) {
    const Descriptor file = take_orphan(path);
    if (!file) return;
    const std::optional<std::string> bytes = read_all(file.number());
    JournalContent content = bytes ? read_journal(*bytes) : JournalContent{JournalContent::State::unreadable};
    if (content.state == JournalContent::State::whole) orphans.found.push_back({path, std::move(content.work)});
    else if (content.state == JournalContent::State::empty) ::unlink(path.c_str());
    else if (content.state == JournalContent::State::unreadable) orphans.unreadable.push_back(path);
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

std::string journal_folder() {
    const char* const state = std::getenv("XDG_STATE_HOME");
    if (state && state[0] == '/') return std::string(state) + "/pinfield";  // the XDG base directories: relative ones are ignored
    const char* const home = std::getenv("HOME");
    return home && home[0] == '/' ? std::string(home) + "/.local/state/pinfield" : std::string();
}

std::string journal_head() { return fmt::format("{}{}\n", head_word, version); }

std::string journal_record(const UnsavedWork& work) {
    std::string payload = hex16(static_cast<std::uint64_t>(work.edits)) + hex16(static_cast<std::uint64_t>(work.time));
    for (const std::string* text : {&work.table, &work.last_label, &work.base, &work.text}) payload += counted(*text);
    if (work.draft) payload += counted(*work.draft);
    return std::string(record_word) + hex16(payload.size()) + Hash64().feed(payload).hex() + payload;
}

JournalContent read_journal(std::string_view bytes) {
    using State = JournalContent::State;
    if (bytes.empty()) return {};
    if (bytes.starts_with(head_word)) {
        const std::string_view number = bytes.substr(head_word.size(), bytes.find('\n') - head_word.size());
        int found_version = version;  // where the head is damaged, the records tell
        std::from_chars(number.data(), number.data() + number.size(), found_version);
        if (found_version > version) return {State::newer};
    }
    JournalContent content{State::unreadable};
    // A record that does not check is stepped over: those behind it may.
    for (std::size_t at = bytes.find(record_word); at != std::string_view::npos;) {
        Record record = record_at(bytes.substr(at));
        if (record.work) content = {State::whole, std::move(*record.work)};
        at = bytes.find(record_word, at + std::max(record.length, std::size_t{1}));
    }
    return content;
}

Result<void> Journal::write(const UnsavedWork& work) {
    if (folder_.empty()) return failure("cannot keep a journal: neither XDG_STATE_HOME nor HOME names a folder");
    if (file_ && !is_at(file_.number(), path_)) forget();  // somebody has removed it
    const std::string record = journal_record(work);
    if (!file_) {
        if (const Result<void> begun = begin(); !begun) return begun;
        const Result<void> written = replace(journal_head() + record, false);
        if (!written) drop();
        return written;
    }
    if (size_ + record.size() > std::max(most_bytes_, records_kept * record.size())) return replace(journal_head() + record, true);
    if (!write_all(file_.number(), record)) return refused(folder_);
    size_ += record.size();
    return {};
}

/// Makes an empty file of an unpredictable name and locks it; until it is replaced it holds nothing.
Result<void> Journal::begin() {
    if (!make_folder(folder_)) return refused(folder_);
    for (int attempt = 0; attempt < 8; ++attempt) {
        std::string path = folder_ + "/XXXXXX" + std::string(ending);
        Descriptor file(::mkostemps(path.data(), static_cast<int>(ending.size()), O_CLOEXEC));  // its mode is 0600
        if (!file) return refused(folder_);
        // Who looks for orphans may have got hold of it first, and have removed it.
        if (::flock(file.number(), LOCK_EX) != 0) {
            const auto failed = refused(folder_);
            ::unlink(path.c_str());
            return failed;
        }
        if (!is_at(file.number(), path)) continue;
        path_ = std::move(path);
        file_ = std::move(file);
        return {};
    }
    return failure(fmt::format("cannot keep a journal in {}: it is removed at once", folder_));
}

/// The new file is locked before it takes the name, so that the name never stands for an unlocked one. `synced`: where older records
/// are given up, their successor must be on the disk.
Result<void> Journal::replace(const std::string& content, bool synced) {
    const std::string temporary = temporary_of(path_);
    ::unlink(temporary.c_str());
    Descriptor file(::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600));
    if (!file) return refused(folder_);
    if (!lock(file.number()) || !write_all(file.number(), content) || (synced && ::fsync(file.number()) != 0) ||
        ::rename(temporary.c_str(), path_.c_str()) != 0) {
        const auto failed = refused(folder_);
        ::unlink(temporary.c_str());
        return failed;
    }
    file_ = std::move(file);
    size_ = content.size();
    name_synced_ = false;
    return {};
}

Result<void> Journal::sync() {
    if (!file_) return {};
    if (::fsync(file_.number()) != 0) return refused(folder_);
    if (!name_synced_) {
        const Descriptor folder(::open(folder_.c_str(), O_RDONLY | O_CLOEXEC));
        if (folder) ::fsync(folder.number());  // not every file system lets a folder be synced
        name_synced_ = true;
    }
    return {};
}

void Journal::drop() {
    if (file_ && is_at(file_.number(), path_)) ::unlink(path_.c_str());
    forget();
}

void Journal::forget() {
    file_ = Descriptor();
    path_.clear();
    size_ = 0;
    name_synced_ = false;
}

Orphans find_orphans(const std::string& folder) {
    Orphans orphans;
    std::vector<std::string> journals, temporaries;
    std::error_code unreadable;
    for (fs::directory_iterator it(folder, unreadable), end; !unreadable && it != end; it.increment(unreadable)) {
        const std::string path = it->path().string();
        if (path.ends_with(ending)) journals.push_back(path);
        else if (path.ends_with(std::string(ending) + std::string(temporary_ending))) temporaries.push_back(path);
    }
    remove_temporaries(temporaries);
    std::sort(journals.begin(), journals.end());
    for (const std::string& path : journals) look_at(path, orphans);
    std::stable_sort(orphans.found.begin(), orphans.found.end(),
                     [](const Orphan& a, const Orphan& b) { return a.work.time > b.work.time; });
    return orphans;
}

bool remove_orphan(const std::string& file) {
    const Descriptor orphan = take_orphan(file);
    if (!orphan) return false;
    ::unlink(temporary_of(file).c_str());
    return ::unlink(file.c_str()) == 0;
}

}  // namespace pinfield::editor
