#include "engine/io/include_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/io/calculate.h"

namespace pinfield {
namespace {

/// What no path may hold on every system: \ and : mean drives and folders on some, and the others hide what a path says.
bool is_strange(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\' || c == ':'; }

std::vector<std::string_view> words_of(std::string_view path) {
    std::vector<std::string_view> out;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        out.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

std::size_t weight_of(const YamlTree& tree) { return tree.root ? static_cast<std::size_t>(tree.root->weight) : tree.nodes.size(); }

}  // namespace

Result<std::string> path_below(std::string_view from, std::string_view path) {
    if (path.starts_with('/')) return failure(fmt::format("{} is a path from the root of the disk", shortened(path)));
    if (std::any_of(path.begin(), path.end(), is_strange)) return failure(R"(no path has a \, a : or a control character in it)");
    std::vector<std::string_view> words = words_of(from);
    words.pop_back();
    for (const std::string_view word : words_of(path)) {
        if (word.empty() || word == ".") continue;
        if (word != "..") words.push_back(word);
        else if (words.empty()) return failure(fmt::format("{} leads out of the table's folder", shortened(path)));
        else words.pop_back();
    }
    if (words.empty() || path.ends_with('/')) return failure(fmt::format("{} names no file", shortened(path)));
    return fmt::format("{}", fmt::join(words, "/"));
}

Inclusion::Inclusion(const SourceText& main, const YamlTree& tree, const OpenFile& open, const TableFiles& known)
    : open_(open), known_(known), bytes_(main.text().size()), events_(weight_of(tree)) {
    const std::size_t name = main.name().rfind('/') + 1;  // 0 where there is none
    folder_ = main.name().substr(0, name);
    way_ = {main.name().substr(name)};
}

void Inclusion::read(ReadContext& context, Sources& sources, const YamlNode& list) {
    if (list.is_empty()) return;
    if (list.kind != YamlKind::sequence) {
        const bool is_path = list.kind == YamlKind::scalar;
        return context.report(Code::wrong_shape, list.span, "a list of files is due here",
                              fmt::format("write include: [{}]", is_path ? shortened(list.text) : "parts/walls.yaml"));
    }
    for (const YamlNode* item : list.items) {
        if (context.full()) return;
        read_item(context, sources, item->resolved());
    }
}

void Inclusion::read_item(ReadContext& context, Sources& sources, const YamlNode& item) {
    if (item.kind != YamlKind::scalar || item.text.empty())
        return context.report(Code::wrong_shape, item.span, "the path of a file is due here");
    const Result<std::string> path = path_below(way_.back(), item.text);
    if (!path) return context.report(Code::bad_path, item.span, path.error().message, "include what stands in the table's folder or below it");
    if (is_open(context, item, *path) || files_.contains(*path)) return;
    if (!may_ask(context, item)) return;
    const auto known = known_.find(*path);
    const File before = known == known_.end() ? nullptr : known->second;
    std::optional<FoundFile> found = before ? FoundFile{before->path, before->source->text()} : find(context, item, *path);
    if (!found || is_open(context, item, found->path)) return;
    if (const auto twin = done_.find(found->path); twin != done_.end()) {  // it goes by another path, too
        files_.emplace(*path, twin->second);
        return;
    }
    if (!fits(context, item, *found)) return;
    const File file = parsed(context, std::move(*found), before, sources.next_file());
    sources.add(file->source, file->path, context.source().place(item.span));
    files_.emplace(*path, file);
    done_.emplace(file->path, file);
    enter(context, sources, *file);
}

/// Names are counted, not files: what a name leads to is known only when it has been opened.
bool Inclusion::may_ask(ReadContext& context, const YamlNode& item) {
    if (asked_++ < context.limits.includes) return true;
    context.report(Code::too_many_includes, item.span, fmt::format("more than {} files", context.limits.includes));
    context.is_exhausted = true;
    return false;
}

std::optional<FoundFile> Inclusion::find(ReadContext& context, const YamlNode& item, const std::string& path) const {
    if (!open_) {
        context.report(Code::unreadable_include, item.span, "a table without a file has no folder to include from", "save it first");
        return {};
    }
    // A byte more than fits tells that it does not.
    const std::size_t room = context.limits.table_bytes - std::min(bytes_, context.limits.table_bytes);
    Result<FoundFile> found = open_(path, std::min(context.limits.file_bytes, room) + 1);
    if (found) return std::move(*found);
    context.report(Code::unreadable_include, item.span, found.error().message);
    return {};
}

bool Inclusion::fits(ReadContext& context, const YamlNode& item, const FoundFile& file) {
    const Limits& limits = context.limits;
    if (file.text.size() > limits.file_bytes) {
        context.report(Code::file_too_large, item.span, fmt::format("{} is larger than {} bytes", file.path, limits.file_bytes));
        return false;
    }
    bytes_ += file.text.size();
    if (bytes_ <= limits.table_bytes) return true;
    context.report(Code::table_too_large, item.span, fmt::format("the table's files together are larger than {} bytes", limits.table_bytes));
    context.is_exhausted = true;
    return false;
}

/// Does the item name a file that it stands in, or one that includes that?
bool Inclusion::is_open(ReadContext& context, const YamlNode& item, const std::string& path) const {
    const auto around = std::find(way_.begin(), way_.end(), path);
    if (around == way_.end()) return false;
    context.report(Code::cyclic_include, item.span,
                   fmt::format("files include each other in a circle: {} -> {}", fmt::join(around, way_.end(), " -> "), path));
    return true;
}

/// The file's text and tree under its number: those of an earlier reading where they are the same.
Inclusion::File Inclusion::parsed(ReadContext& context, FoundFile found, const File& before, FileId number) {
    const std::string name = folder_ + found.path;
    File file = before;
    const bool is_same = before && before->source->file() == number && before->source->name() == name &&
                         events_ + weight_of(*before->tree) <= context.limits.events;
    if (!is_same) {
        Limits limits = context.limits;
        limits.events_before = events_;
        auto source = std::make_shared<const SourceText>(name, std::move(found.text), number);
        auto tree = std::make_shared<const YamlTree>(read_yaml(*source, limits));
        file = std::make_shared<const TableFile>(TableFile{std::move(found.path), std::move(source), std::move(tree)});
    }
    events_ += weight_of(*file->tree);
    return file;
}

void Inclusion::enter(ReadContext& context, Sources& sources, const TableFile& file) {
    const InText there(context, file.source.get());
    for (const Diagnostic& found : file.tree->diagnostics) context.report(found);
    const YamlNode* root = file.tree->root;
    if (!root) return;
    if (root->kind != YamlKind::map) return context.report(Code::wrong_shape, root->span, "a file of a table is a map of sections", "begin with: pinfield: 1");
    way_.push_back(file.path);
    for (std::size_t i = 0; i < root->entries(); ++i)
        if (root->key(i).text == "include" && is_plain_key(root->key(i))) read(context, sources, root->value(i).resolved());
    way_.pop_back();
    context.files.push_back({file.source.get(), root});
}

}  // namespace pinfield
