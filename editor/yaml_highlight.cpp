#include "editor/yaml_highlight.h"

#include <algorithm>

#include "engine/core/numbers.h"
#include "engine/io/quantity.h"

namespace pinfield::editor {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_break(char c) { return c == '\n' || c == '\r'; }
bool is_flow_mark(char c) { return c == ',' || c == '[' || c == ']' || c == '{' || c == '}'; }

/// Digits, and a unit that some field takes.
bool is_quantity(std::string_view word) {
    if (word.empty() || std::string_view("+-.0123456789").find(word[0]) == std::string_view::npos) return false;
    if (parse_number(word)) return true;
    const auto units = unit_suffixes();
    return std::any_of(units.begin(), units.end(), [&](const UnitSuffix& unit) {
        return word.ends_with(unit.text) && parse_number(word.substr(0, word.size() - unit.text.size()));
    });
}

bool is_keyword(std::string_view word) { return word == "true" || word == "false" || word == "null" || word == "~"; }

class Highlighter {
public:
    explicit Highlighter(std::string_view text) : text_(text), at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0), line_(at_) {}

    std::vector<Token> run() {
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n'; }
    bool blank_at(std::size_t place) const { return place >= text_.size() || is_blank(text_[place]) || is_break(text_[place]); }
    bool in_flow() const { return !brackets_.empty(); }

    void add(std::size_t end, TokenKind kind) {
        tokens_.push_back({{at_, end}, kind});
        at_ = end;
    }
    void mark(std::size_t length) { add(at_ + length, TokenKind::mark); }

    void step() {
        const char c = peek();
        if (is_break(c)) {
            line_ = ++at_;
            return;
        }
        if (is_blank(c)) return void(++at_);
        if (at_ == line_ && c != ']' && c != '}') brackets_.clear();
        const bool separate = at_ == line_ || is_blank(text_[at_ - 1]);
        if (c == '#' && separate) return add(line_end(at_), TokenKind::comment);
        if (at_ == line_ && !in_flow() && (text_.substr(at_, 3) == "---" || text_.substr(at_, 3) == "...") && blank_at(at_ + 3)) return mark(3);
        if (is_flow_mark(c) && (in_flow() || c == '[' || c == '{')) return bracket(c);
        if ((c == '-' || c == '?') && !in_flow() && blank_at(at_ + 1)) {
            begins_item_ = c == '-';
            return mark(1);
        }
        if (c == ':' && (blank_at(at_ + 1) || in_flow())) return mark(1);
        if (c == '&' || c == '*' || c == '!') return add(word_end(), TokenKind::anchor);
        if (c == '"' || c == '\'') return scalar(quote_end(c), true);
        if ((c == '|' || c == '>') && !in_flow()) return block();
        scalar(plain_end(), false);
    }

    void bracket(char c) {
        if (c == '[' || c == '{') brackets_.push_back(c);
        else if (c != ',') brackets_.pop_back();
        begins_item_ = in_flow() && brackets_.back() == '[' && (c == '[' || c == ',');
        mark(1);
    }

    std::size_t line_end(std::size_t from) const {
        const std::size_t end = std::min(text_.find('\n', from), text_.size());
        return end > from && end < text_.size() && text_[end - 1] == '\r' ? end - 1 : end;
    }
    /// Nothing that is open goes on over a line that begins at the margin.
    bool at_margin(std::size_t place) const { return place < text_.size() && !is_blank(text_[place]) && !is_break(text_[place]); }

    std::size_t word_end() const {
        std::size_t end = at_ + 1;
        while (!blank_at(end) && !(in_flow() && is_flow_mark(text_[end]))) ++end;
        return end;
    }

    /// Behind the closing quote; an open one ends with its line.
    std::size_t quote_end(char quote) const {
        for (std::size_t end = at_ + 1; end < text_.size(); ++end) {
            const bool escapes = text_[end] == '\\' && quote == '"';
            const bool doubled = text_[end] == quote && quote == '\'' && end + 1 < text_.size() && text_[end + 1] == quote;
            if (escapes || doubled) ++end;
            else if (text_[end] == quote) return end + 1;
            else if (text_[end] == '\n' && at_margin(end + 1)) break;
        }
        return line_end(at_);
    }

    std::size_t plain_end() const {
        std::size_t end = at_, solid = at_ + 1;
        for (; end < text_.size() && !is_break(text_[end]); ++end) {
            const char c = text_[end];
            if (end > at_ && in_flow() && is_flow_mark(c)) break;
            if (end > at_ && c == '#' && is_blank(text_[end - 1])) break;
            if (end > at_ && c == ':' && (blank_at(end + 1) || (in_flow() && is_flow_mark(text_[end + 1])))) break;
            if (!is_blank(c)) solid = end + 1;
        }
        return solid;
    }

    bool colon_follows(std::size_t place, bool quoted) const {
        while (place < text_.size() && is_blank(text_[place])) ++place;
        if (place >= text_.size() || text_[place] != ':') return false;
        return blank_at(place + 1) || (in_flow() && (quoted || is_flow_mark(text_[place + 1])));
    }

    void scalar(std::size_t end, bool quoted) {
        const std::string_view word = text_.substr(at_, end - at_);
        TokenKind kind = quoted ? TokenKind::quoted : is_quantity(word) ? TokenKind::number : is_keyword(word) ? TokenKind::keyword : TokenKind::word;
        if (colon_follows(end, quoted)) kind = begins_item_ ? TokenKind::type : at_ == line_ && !in_flow() ? TokenKind::section : TokenKind::key;
        begins_item_ = false;
        add(end, kind);
    }

    /// The lines under | or >: those that stand further right than the line that opens them, and blank ones between.
    void block() {
        const std::size_t header = at_ + std::min(text_.substr(at_, line_end(at_) - at_).find(" #"), line_end(at_) - at_);
        std::size_t indent = line_;
        while (is_blank(text_[indent])) ++indent;
        indent -= line_;
        begins_item_ = false;
        add(header, TokenKind::mark);
        while (true) {  // a comment may follow the sign
            while (is_blank(peek()) && at_ < text_.size()) ++at_;
            if (peek() == '#' && at_ < text_.size()) add(line_end(at_), TokenKind::comment);
            if (at_ < text_.size() && peek() == '\r') ++at_;
            if (at_ >= text_.size()) return;
            line_ = ++at_;
            const std::size_t end = line_end(at_);
            std::size_t words = at_;
            while (words < end && is_blank(text_[words])) ++words;
            if (words < end && words - at_ <= indent) return;
            at_ = words;
            if (words < end) add(end, TokenKind::quoted);
        }
    }

    std::string_view text_;
    std::size_t at_, line_;  ///< the next byte, and the first of its line
    std::vector<char> brackets_;
    bool begins_item_ = false;
    std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> highlight_yaml(std::string_view text) { return Highlighter(text).run(); }

}  // namespace pinfield::editor
