#include "engine/io/yaml_tree.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <map>
#include <optional>
#include <set>
#include <streambuf>

#include "engine/core/error_codes.h"
#include "engine/io/yaml_text.h"

namespace pinfield {
namespace {

/// yaml-cpp writes the escapes \_ and \N as one byte, which is no UTF-8: here as the two that U+00A0 and U+0085 take. The source is UTF-8,
/// so a byte like that where a character should begin comes from nowhere else.
std::string in_utf8(const std::string& value) {
    std::string out;
    for (std::size_t i = 0; i < value.size();) {
        const auto lead = static_cast<unsigned char>(value[i]);
        const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
        if (lead == 0xA0 || lead == 0x85) out += '\xC2';
        out.append(value, i, length);
        i += length;
    }
    return out;
}

/// Ends the parse after a finding that makes the rest meaningless; never leaves this file.
struct Stop {};

/// The text as a stream, without a copy, handed out in pieces. The parser swallows a scalar whole before anybody can
/// judge its length, so the text ends early when far more than a scalar may have was asked for without an event.
class Bytes : public std::streambuf {
public:
    Bytes(std::string_view text, std::size_t most_without_event) : text_(text), most_(most_without_event) {}

    void event() { given_at_event_ = given_; }
    bool cut_short() const { return cut_short_; }

protected:
    int_type underflow() override {
        cut_short_ = cut_short_ || given_ - given_at_event_ > most_;
        if (cut_short_ || given_ == text_.size()) return traits_type::eof();
        const std::size_t count = std::min<std::size_t>(4096, text_.size() - given_);
        char* begin = const_cast<char*>(text_.data()) + given_;  // a get area is never written to
        given_ += count;
        setg(begin, begin, begin + count);
        return traits_type::to_int_type(*begin);
    }

private:
    std::string_view text_;
    std::size_t most_, given_ = 0, given_at_event_ = 0;
    bool cut_short_ = false;
};

class Builder : public YAML::EventHandler {
public:
    Builder(const SourceText& source, const Limits& limits, YamlTree& tree)
        : source_(source),
          text_(source.text()),
          limits_(limits),
          tree_(tree),
          mark_offset_(byte_order_mark(text_)),
          bytes_(text_.substr(mark_offset_), 16 * limits.scalar_bytes),
          expanded_(limits.events_before) {}

    /// Parses the whole text; the tree has no root when it could not be read to its end.
    void parse() {
        std::istream in(&bytes_);
        const std::size_t findings = tree_.diagnostics.size();
        try {
            YAML::Parser parser(in);
            while (parser.HandleNextDocument(*this)) {
            }
            if (!bytes_.cut_short()) return;
        } catch (const Stop&) {
        } catch (const YAML::Exception& e) {
            explain(e);
        }
        tree_.root = nullptr;
        if (!bytes_.cut_short()) return;
        tree_.diagnostics.resize(findings);  // whatever the parser made of a text that ends in its middle
        report(Code::scalar_too_long, place_so_far(),
               fmt::format("no value for more than {} bytes from here on", 16 * limits_.scalar_bytes));
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        bytes_.event();
        if (tree_.root)
            stop(Code::several_documents, at(mark), "a second YAML document begins here",
                 "a table is one document: remove the ---");
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const std::size_t begin = skip_properties(text_, at(mark));
        // Where a value is missing the parser gives the place of whatever comes next; what is written as ~ is a value.
        if (const std::size_t word = null_word(text_, begin); word > 0) {
            YamlNode& node = add(YamlKind::scalar, anchor);
            node.span = {begin, begin + word};
            node.text = text_.substr(begin, word);
            attach(node);
            return;
        }
        YamlNode& node = add(YamlKind::null, anchor);
        const std::size_t place = expects_value() ? after_colon() : at(mark);
        node.span = {place, place};
        attach(node);
    }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const std::size_t begin = at(mark);
        YamlNode& node = add(YamlKind::alias, YAML::NullAnchor);
        std::size_t end = begin + 1;
        while (end < text_.size() && std::string_view(" \t\r\n,[]{}").find(text_[end]) == std::string_view::npos) ++end;
        node.span = {begin, end};
        node.text = text_.substr(begin + 1, end - begin - 1);
        const auto target = anchors_.find(anchor);
        if (target == anchors_.end() || is_open(target->second))
            stop(Code::cyclic_alias, begin,
                 fmt::format("*{} stands inside &{}, which it repeats", node.text, node.text));
        node.target = target->second;
        ++node.target->references;
        node.height = node.target->height;
        node.weight = node.target->weight;
        if (open_.size() + node.height > limits_.depth || (expanded_ += node.weight) > limits_.events)
            stop(Code::alias_bomb, begin, "the aliases up to here expand to more than the limits allow");
        attach(node);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        reject_tag(mark, tag);
        if (value.size() > limits_.scalar_bytes)
            stop(Code::scalar_too_long, at(mark),
                 fmt::format("a value of {} bytes; at most {} are read", value.size(), limits_.scalar_bytes));
        YamlNode& node = add(YamlKind::scalar, anchor);
        const std::size_t begin = skip_properties(text_, at(mark));
        node.style = scalar_style(text_, begin);
        node.span = {begin, scalar_end(text_, begin, node.style, value, indent())};
        if (node.style != YamlStyle::plain && node.style != YamlStyle::block_text && !is_closed(node.span))
            stop(Code::yaml_syntax, begin, "this quote is never closed");
        const std::string_view written = text_.substr(begin, node.span.end - begin);
        const std::string_view inner =
            node.style == YamlStyle::plain || written.size() < 2 ? written : written.substr(1, written.size() - 2);
        node.text = inner == value ? inner : tree_.texts.emplace_back(in_utf8(value));
        attach(node);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value style) override {
        reject_tag(mark, tag);
        open(YamlKind::sequence, mark, anchor, style == YAML::EmitterStyle::Flow ? YamlStyle::flow : YamlStyle::block);
    }
    void OnSequenceEnd() override { close(']'); }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value style) override {
        reject_tag(mark, tag);
        open(YamlKind::map, mark, anchor, style == YAML::EmitterStyle::Flow ? YamlStyle::flow : YamlStyle::block);
        keys_.emplace_back();
    }
    void OnMapEnd() override {
        keys_.pop_back();
        close('}');
    }

private:
    /// What a parser's exception means for the author.
    void explain(const YAML::Exception& e) {
        const std::size_t place = e.mark.is_null() ? text_.size() : std::min(at(e.mark), text_.size());
        const std::string_view what = e.msg;
        if (what == YAML::ErrorMsg::UNKNOWN_ANCHOR)
            return report(Code::unknown_alias, place, "this alias names no anchor above it",
                          "a value that begins with * must be quoted; there are no wildcards");
        if (what == YAML::ErrorMsg::BAD_FILE) return report(Code::too_deep, place, "the nesting is too deep");
        if (what == YAML::ErrorMsg::TAB_IN_INDENTATION)
            return report(Code::tab_indentation, place, "a tab in the indentation", "indent with spaces");
        if (what == YAML::ErrorMsg::END_OF_MAP_FLOW || what == YAML::ErrorMsg::END_OF_SEQ_FLOW)
            return explain_unclosed(place);
        if (what == YAML::ErrorMsg::FLOW_END && place < text_.size()) return explain_wrong_end(place);
        if (what == YAML::ErrorMsg::MAP_VALUE)
            return report(Code::yaml_syntax, place, "a key cannot stand here",
                          "quote a text that holds a colon and a blank, and align the keys of a map");
        report(Code::yaml_syntax, place, std::string(what), hint_for(what));
    }

    struct Open {
        YamlNode* node;
        int column;  // of a block collection's first key or dash: what belongs to it is indented deeper
    };

    std::size_t at(const YAML::Mark& mark) const { return static_cast<std::size_t>(mark.pos) + mark_offset_; }

    void report(Code code, std::size_t place, std::string message, std::string hint = {}) {
        tree_.diagnostics.push_back(
            diagnose(code, source_.place({place, std::min(place + 1, text_.size())}), std::move(message), std::move(hint)));
    }
    [[noreturn]] void stop(Code code, std::size_t place, std::string message, std::string hint = {}) {
        report(code, place, std::move(message), std::move(hint));
        throw Stop{};
    }

    static std::string hint_for(std::string_view what) {
        if (what == YAML::ErrorMsg::UNKNOWN_TOKEN) return "quote a text that begins with a sign";
        if (what == YAML::ErrorMsg::EOF_IN_SCALAR) return "a quote is never closed";
        if (what == YAML::ErrorMsg::END_OF_MAP || what == YAML::ErrorMsg::END_OF_SEQ)
            return "lines of one list or map begin in the same column";
        return {};
    }

    /// Where the innermost open [ or { stands.
    std::optional<std::size_t> innermost_flow() const {
        for (auto it = open_.rbegin(); it != open_.rend(); ++it)
            if (it->node->style == YamlStyle::flow) return it->node->span.begin;
        return {};
    }

    void explain_wrong_end(std::size_t place) {
        if (const auto begin = innermost_flow())
            return report(Code::yaml_syntax, *begin, fmt::format("this {} is not closed: a {} comes first", text_[*begin], text_[place]));
        report(Code::yaml_syntax, place, fmt::format("this {} closes nothing", text_[place]));
    }

    void explain_unclosed(std::size_t place) {
        if (const Span span = value_with_colon(text_, place); span.begin < span.end) {
            const std::string_view value = text_.substr(span.begin, std::min<std::size_t>(span.end - span.begin, 60));
            return report(Code::yaml_syntax, span.begin, fmt::format("a second colon in one entry: {}", value),
                          fmt::format("quote a text that holds a colon and a blank: \"{}\"", value));
        }
        const std::size_t begin = innermost_flow().value_or(place);
        if (const auto color = color_in_comment(text_, begin, text_.size()))
            return report(Code::comment_ate_value, *color, "this # begins a comment that swallows the rest of the line",
                          "quote the color: \"#7c5\"");
        report(Code::yaml_syntax, begin,
               fmt::format("this {} is never closed", begin < text_.size() ? text_[begin] : '{'));
    }

    /// The parser gives "?" to plain and "!" to quoted scalars that carry no tag.
    void reject_tag(const YAML::Mark& mark, const std::string& tag) {
        std::size_t begin = at(mark);
        if (begin < text_.size() && text_[begin] == '&') {  // an anchor may stand before a tag
            while (begin < text_.size() && text_[begin] != ' ' && text_[begin] != '\n') ++begin;
            begin = skip_blank(text_, begin);
        }
        const bool bare = tag.empty() || tag == "?" || (tag == "!" && (begin >= text_.size() || text_[begin] != '!'));
        if (!bare)
            stop(Code::tag, begin, fmt::format("the tag {} is not part of the format", tag),
                 "quote a text that begins with !");
    }

    YamlNode& add(YamlKind kind, YAML::anchor_t anchor) {
        bytes_.event();
        if (++expanded_ > limits_.events || tree_.nodes.size() >= limits_.events)
            stop(Code::too_many_events, place_so_far(), fmt::format("more than {} YAML events", limits_.events));
        YamlNode& node = tree_.nodes.emplace_back();
        node.kind = kind;
        if (anchor != YAML::NullAnchor) {
            node.anchored = true;
            anchors_[anchor] = &node;
        }
        return node;
    }

    std::size_t place_so_far() const { return tree_.nodes.empty() ? 0 : tree_.nodes.back().span.begin; }

    bool is_open(const YamlNode* node) const {
        return std::any_of(open_.begin(), open_.end(), [&](const Open& o) { return o.node == node; });
    }
    bool expects_value() const {
        return !open_.empty() && open_.back().node->kind == YamlKind::map && open_.back().node->items.size() % 2 == 1;
    }
    std::size_t after_colon() const {
        const std::size_t end = open_.back().node->items.back()->span.end, colon = skip_spaces(text_, end);
        return colon < text_.size() && text_[colon] == ':' ? colon + 1 : end;
    }
    bool is_closed(Span span) const { return span.end > span.begin + 1 && text_[span.end - 1] == text_[span.begin]; }
    int indent() const { return open_.empty() ? -1 : open_.back().column; }

    void attach(YamlNode& node) {
        if (open_.empty()) {
            tree_.root = &node;
            return;
        }
        YamlNode& parent = *open_.back().node;
        node.parent = &parent;
        if (parent.kind == YamlKind::map && parent.items.size() % 2 == 0) check_key(node);
        parent.items.push_back(&node);
    }

    void check_key(const YamlNode& key) {
        if (key.kind != YamlKind::scalar) {
            report_key(Code::bad_key, key, "a key is a plain word");
            return;
        }
        if (key.text == "<<" && key.style == YamlStyle::plain)
            report_key(Code::merge_key, key, "the merge key << is not part of the format", "write the fields out");
        else if (!keys_.back().insert(key.text).second)
            report_key(Code::duplicate_key, key, fmt::format("{} is said twice here", key.text),
                       "remove one of the two");
    }

    void report_key(Code code, const YamlNode& key, std::string message, std::string hint = {}) {
        if (tree_.diagnostics.size() >= limits_.errors)
            stop(Code::too_many_errors, key.span.begin, std::string(more_errors_follow));
        report(code, key.span.begin, std::move(message), std::move(hint));
    }

    void open(YamlKind kind, const YAML::Mark& mark, YAML::anchor_t anchor, YamlStyle style) {
        if (open_.size() >= limits_.depth)
            stop(Code::too_deep, at(mark), fmt::format("more than {} levels are nested", limits_.depth));
        YamlNode& node = add(kind, anchor);
        const std::size_t begin = skip_properties(text_, at(mark));
        node.style = style;
        node.span = {begin, begin};
        if (kind == YamlKind::map && style == YamlStyle::flow && (begin >= text_.size() || text_[begin] != '{'))
            node.style = YamlStyle::pair;
        attach(node);
        const int column = style == YamlStyle::block ? static_cast<int>(begin - line_begin(text_, begin)) : indent();
        open_.push_back({&node, column});
    }

    void close(char bracket) {
        YamlNode& node = *open_.back().node;
        open_.pop_back();
        std::size_t end = node.items.empty() ? node.span.begin + 1 : node.items.back()->span.end;
        if (node.style == YamlStyle::flow) {
            while (end < text_.size() && text_[end] != bracket) {
                const std::size_t next = skip_blank(text_, end);
                end = next == end ? end + 1 : next;  // steps over the comma and the colon of a missing value
            }
            ++end;
        }
        node.span.end = std::min(end, text_.size());
        for (const YamlNode* item : node.items) {
            node.weight += item->weight;
            node.height = std::max(node.height, item->height + 1);
        }
    }

    const SourceText& source_;
    std::string_view text_;
    const Limits& limits_;
    YamlTree& tree_;
    std::size_t mark_offset_;
    Bytes bytes_;
    std::vector<Open> open_;
    std::vector<std::set<std::string_view>> keys_;  // of each open map
    std::map<YAML::anchor_t, YamlNode*> anchors_;
    std::uint64_t expanded_;
};

}  // namespace

bool YamlNode::is_empty() const {
    return kind == YamlKind::null || (kind == YamlKind::scalar && style == YamlStyle::plain &&
                                      (text == "~" || text == "null" || text == "Null" || text == "NULL"));
}

std::size_t YamlNode::entry_of(std::string_view wanted) const {
    std::size_t i = 0;
    while (i < entries() && key(i).text != wanted) ++i;
    return i;
}

const YamlNode* YamlNode::find(std::string_view wanted) const {
    if (kind != YamlKind::map) return nullptr;
    const std::size_t i = entry_of(wanted);
    return i < entries() ? &value(i).resolved() : nullptr;
}

const YamlNode* node_at(const YamlTree& tree, Span span) {
    const auto found = std::find_if(tree.nodes.begin(), tree.nodes.end(), [&](const YamlNode& node) { return node.span == span; });
    return found == tree.nodes.end() ? nullptr : &*found;
}

YamlTree read_yaml(const SourceText& source, const Limits& limits) {
    YamlTree tree;
    tree.diagnostics = check_text(source, limits);
    if (has_errors(tree.diagnostics)) return tree;
    Builder(source, limits, tree).parse();
    if (!tree.root && tree.diagnostics.empty())
        tree.diagnostics.push_back(
            diagnose(Code::empty_file, source.place({0, 0}), "the file holds no table", "begin with: pinfield: 1"));
    return tree;
}

}  // namespace pinfield
