#include "editor/panels/source_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/source_places.h"
#include "editor/widgets/widgets.h"
#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr Tint comment_color = Role::yaml_comment;
constexpr Tint key_color = Role::yaml_key;
constexpr Tint number_color = Role::yaml_number;
constexpr Tint quoted_color = Role::yaml_quoted;
constexpr Tint anchor_color = Role::yaml_anchor;

int characters_in(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

class Lines {
public:
    Lines(AppState& state, Ui& ui, const std::vector<SourceMark>& marks)
        : state_(state), ui_(ui), panel_(ui.source), theme_(ui.theme), marks_(marks), text_(*ui.source.shown), list_(*ImGui::GetWindowDrawList()),
          height_(source_line_height(theme_)), advance_(theme_.mono->GetCharAdvance('0')) {
        window_ = ImGui::GetWindowPos();
        const float bar = ImGui::GetStyle().ScrollbarSize;
        inner_ = {ImGui::GetWindowSize().x - (ImGui::GetScrollMaxY() > 0 ? bar : 0), ImGui::GetWindowSize().y - (ImGui::GetScrollMaxX() > 0 ? bar : 0)};
        const auto digits = static_cast<float>(std::max<std::size_t>(3, std::to_string(text_.line_count()).size()));
        gutter_ = std::ceil(theme_.px(20) + digits * advance_ + theme_.px(9));
    }

    void draw() {
        const auto rows = static_cast<float>(text_.line_count());
        const ImVec2 size{gutter_ + theme_.px(10) + advance_ * static_cast<float>(panel_.widest + 2), rows * height_ + theme_.px(8)};
        origin_ = ImGui::GetCursorScreenPos();
        ImGui::InvisibleButton("##text", {std::max(size.x, inner_.x), std::max(size.y, inner_.y)});
        first_ = std::clamp(static_cast<int>((window_.y - origin_.y) / height_) + 1, 1, text_.line_count());
        last_ = std::clamp(first_ + static_cast<int>(inner_.y / height_) + 1, 1, text_.line_count());
        mouse();
        reveal();
        paint();
    }

private:
    float y_of(int line) const { return origin_.y + static_cast<float>(line - 1) * height_; }
    float text_x() const { return origin_.x + gutter_ + theme_.px(10); }
    std::size_t begin_of(int line) const { return static_cast<std::size_t>(text_.line(line).data() - text_.text().data()); }
    float x_of(int line, std::size_t offset) const {
        const std::size_t begin = std::max(begin_of(line), snapped(text_.text(), 0));  // a byte order mark has no width
        return text_x() + advance_ * static_cast<float>(characters_in(text_.slice({begin, std::max(begin, offset)})));
    }

    // ---- Between the document's places and those of the text that is shown.
    LineRange lines_of_node(NodeId id) const {
        const Node* node = state_.document.scene().find(id);
        if (!node || node->where.file != main_file) return {};
        return lines_of(text_, {carried(node->where.span.begin, panel_.typed), carried(node->where.span.end, panel_.typed)});
    }

    /// The node under a place of the line: the innermost there, else the one that the line is about.
    NodeId node_under(int line, std::size_t offset) const {
        const Scene& scene = state_.document.scene();
        const Splice back = inverse(state_.document.source().text(), panel_.typed);
        const std::string_view words = text_.line(line);
        const std::size_t begin = begin_of(line), end = begin + words.size();
        if (words.find_first_not_of(" \t\r") == std::string_view::npos) return {};
        if (offset > begin + words.find_first_not_of(" \t") && offset < end) {
            const std::size_t place = carried(offset, back);
            const NodeId node = node_at(scene, text_.place({place, place}));
            if (node) return node;
        }
        return node_of_line(scene, state_.document.source().line_column(carried(begin + words.find_first_not_of(" \t"), back)).line);
    }

    // ---- The mouse.
    int line_under_mouse() const {
        return std::clamp(static_cast<int>(std::floor((ImGui::GetIO().MousePos.y - origin_.y) / height_)) + 1, 1, text_.line_count());
    }
    std::size_t offset_under_mouse(int line) const {
        const float column = (ImGui::GetIO().MousePos.x - text_x()) / advance_;
        return offset_at(text_, line, 1 + std::max(0, static_cast<int>(std::lround(column))));
    }
    /// Of the character that the mouse is on, not of the gap that is nearest.
    std::size_t character_under_mouse(int line) const {
        const float column = (ImGui::GetIO().MousePos.x - text_x()) / advance_;
        return column < 0 ? begin_of(line) : offset_at(text_, line, 1 + static_cast<int>(column));
    }

    void mouse() {
        const bool hot = ImGui::IsItemHovered(), on_line = ImGui::GetIO().MousePos.y < y_of(text_.line_count() + 1);
        const int line = line_under_mouse();
        if (ImGui::IsItemActivated() && ImGui::GetIO().MouseDown[0]) press(line, on_line);
        if (!ImGui::IsItemActive()) panel_.dragging = false;
        if (panel_.dragging && ImGui::IsMouseDragging(0)) {
            panel_.cursor.caret = offset_under_mouse(line);
            panel_.reveals_caret = true;
        }
        if (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0) panel_.hand_on_keys = false;
        if (!hot || panel_.hand_on_keys) return;
        const bool in_gutter = ImGui::GetIO().MousePos.x < window_.x + gutter_;
        ImGui::SetMouseCursor(in_gutter ? ImGuiMouseCursor_Arrow : ImGuiMouseCursor_TextInput);
        if (in_gutter) margin_tip(line);
        if (!on_line) return;
        if (!panel_.dragging) ui_.hovered = node_under(line, character_under_mouse(line));
        for (const SourceMark& mark : marks_)
            if (mark_lines(mark).first == line) return tooltip(theme_, mark.text);
    }

    void margin_tip(int line) const {
        if (!panel_.changes) return;
        for (const LineMark& mark : panel_.changes->lines)
            if (mark.line == line && !mark.removed.empty()) return tooltip(theme_, "Saved:\n" + mark.removed.substr(0, 600));
    }

    void press(int line, bool on_line) {
        const ImGuiIO& io = ImGui::GetIO();
        panel_.focused = panel_.dragging = true;
        const std::size_t offset = offset_under_mouse(line);
        if (io.MousePos.x < window_.x + gutter_) {
            panel_.cursor = {line < text_.line_count() ? begin_of(line + 1) : text_.text().size(), offset_at(text_, line, 1)};
            panel_.dragging = false;
        } else if (ImGui::IsMouseDoubleClicked(0)) {
            panel_.cursor = word_at(text_.text(), offset);
            panel_.dragging = false;
        } else {
            panel_.cursor = io.KeyShift ? TextCursor{offset, panel_.cursor.anchor} : cursor_at(offset);
        }
        const NodeId node = on_line && !io.KeyShift ? node_under(line, character_under_mouse(line)) : NodeId{};
        if (!node) return;
        select(state_, node);
        panel_.revealed = node;  // it is under the mouse
    }

    // ---- Scrolling.
    bool is_seen(int line) const { return y_of(line) >= window_.y && y_of(line + 1) <= window_.y + inner_.y; }

    void reveal() {
        if (panel_.wanted) {
            panel_.cursor = cursor_at(snapped(text_.text(), *std::exchange(panel_.wanted, std::nullopt)));
            panel_.reveals_caret = true;
        }
        if (const NodeId chosen = state_.selection.primary(); chosen != panel_.revealed) {
            panel_.revealed = chosen;
            const LineRange lines = chosen ? lines_of_node(chosen) : LineRange{};
            if (lines.last > 0 && !panel_.focused) panel_.cursor = cursor_at(offset_at(text_, lines.first, 1));
            if (lines.last > 0 && !is_seen(lines.first)) scroll_to(lines.first);
            if (lines.last > 0) ImGui::SetScrollX(0);
        }
        if (std::exchange(panel_.reveals_caret, false)) reveal_caret();
    }

    void scroll_to(int line) const { ImGui::SetScrollY(std::max(0.0f, static_cast<float>(line - 1) * height_ - inner_.y / 3)); }

    void reveal_caret() const {
        const int line = text_.line_column(panel_.cursor.caret).line;
        const float top = static_cast<float>(line - 1) * height_, bottom = top + height_;
        const float far = 5 * height_;
        if (top < ImGui::GetScrollY() - far || bottom > ImGui::GetScrollY() + inner_.y + far) scroll_to(line);
        else if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
        else if (bottom > ImGui::GetScrollY() + inner_.y) ImGui::SetScrollY(bottom - inner_.y);
        const float x = x_of(line, panel_.cursor.caret) - origin_.x, room = inner_.x - 4 * advance_;
        if (x - gutter_ - 4 * advance_ < ImGui::GetScrollX()) ImGui::SetScrollX(std::max(0.0f, x - gutter_ - 4 * advance_));
        else if (x > ImGui::GetScrollX() + room) ImGui::SetScrollX(x - room);
    }

    // ---- Painting: backgrounds, text, what is wrong with it, the margin.
    void paint() {
        const ImVec2 end{window_.x + inner_.x, window_.y + inner_.y};
        for (const NodeId node : state_.selection.nodes()) row_tint(lines_of_node(node), palette::accent_deep.faded(0.55f));
        if (ui_.hovered && !state_.selection.contains(ui_.hovered)) row_tint(lines_of_node(ui_.hovered), palette::field);
        list_.PushClipRect({window_.x + gutter_, window_.y}, end, true);
        const Span selected = panel_.cursor.selected();
        for (int line = first_; line <= last_; ++line) {
            if (panel_.cursor.selects()) selection(line, selected);
            words(line);
        }
        for (const SourceMark& mark : marks_) underline(mark);
        if (panel_.focused) caret();
        list_.PopClipRect();
        margin();
        if (panel_.focused) list_.AddRect(window_, end, ink(palette::accent.faded(0.6f)));
    }

    void row_tint(LineRange lines, const Tint& color) const {
        lines = {std::max(lines.first, first_), std::min(lines.last, last_)};
        if (lines.last >= lines.first)
            list_.AddRectFilled({window_.x, y_of(lines.first)}, {window_.x + inner_.x, y_of(lines.last + 1)}, ink(color));
    }

    void selection(int line, const Span& selected) const {
        const std::size_t begin = begin_of(line), end = begin + text_.line(line).size();
        if (selected.begin > end || selected.end < begin) return;
        const bool goes_on = selected.end > end;  // the line's break is selected, too
        const float from = x_of(line, std::max(begin, selected.begin)), to = x_of(line, std::min(end, selected.end));
        list_.AddRectFilled({from, y_of(line)}, {to + (goes_on ? 0.6f * advance_ : 0), y_of(line + 1)}, ink(palette::accent.faded(0.35f)));
    }

    Tint color_of_token(const Token& token) const {
        switch (token.kind) {
            case TokenKind::comment: return comment_color;
            case TokenKind::section: return palette::text;
            case TokenKind::key: return key_color;
            case TokenKind::type: {
                const NodeType* type = state_.catalog->find(text_.slice(token.span));
                return type ? color_of(*type) : key_color;
            }
            case TokenKind::quoted: return quoted_color;
            case TokenKind::number:
            case TokenKind::keyword: return number_color;
            case TokenKind::anchor: return anchor_color;
            case TokenKind::mark: return palette::quiet;
            case TokenKind::word: break;
        }
        return palette::text;
    }

    void words(int line) const {
        const std::size_t begin = begin_of(line), end = begin + text_.line(line).size();
        auto token = std::lower_bound(panel_.tokens.begin(), panel_.tokens.end(), begin, [](const Token& t, std::size_t place) { return t.span.end <= place; });
        const float y = y_of(line) + std::floor(0.5f * (height_ - theme_.mono->FontSize)), right = window_.x + inner_.x;
        std::size_t at = std::max(begin, snapped(text_.text(), 0));
        float x = text_x();
        for (; token != panel_.tokens.end() && token->span.begin < end && x < right; ++token) {
            const Span piece{std::max(token->span.begin, begin), std::min(token->span.end, end)};
            x += advance_ * static_cast<float>(characters_in(text_.slice({at, std::max(at, piece.begin)})));
            std::string shown(text_.slice(piece));
            std::replace(shown.begin(), shown.end(), '\t', ' ');  // one place of the cursor, one place on the screen
            list_.AddText(theme_.mono, theme_.mono->FontSize, {x, y}, ink(color_of_token(*token)), shown.c_str(), shown.c_str() + shown.size());
            x += advance_ * static_cast<float>(characters_in(shown));
            at = piece.end;
        }
    }

    LineRange mark_lines(const SourceMark& mark) const { return lines_of(text_, mark.span); }

    /// On its first line, at least a character wide.
    void underline(const SourceMark& mark) const {
        const int line = mark_lines(mark).first;
        if (line < first_ || line > last_) return;
        const std::size_t end = begin_of(line) + text_.line(line).size();
        const float from = x_of(line, mark.span.begin), to = std::max(x_of(line, std::min(mark.span.end, end)), from + advance_);
        const float y = y_of(line + 1) - theme_.px(2), step = theme_.px(3);
        const ImU32 color = ink(mark.error ? palette::coral : palette::amber);
        const int waves = static_cast<int>(std::ceil((to - from) / (2 * step)));
        for (int i = 0; i < waves; ++i) {
            const float x = from + static_cast<float>(2 * i) * step;
            list_.AddLine({x, y}, {x + step, y - theme_.px(2)}, color, std::max(1.0f, theme_.px(1)));
            list_.AddLine({x + step, y - theme_.px(2)}, {x + 2 * step, y}, color, std::max(1.0f, theme_.px(1)));
        }
    }

    void caret() const {
        const int line = text_.line_column(panel_.cursor.caret).line;
        const float x = x_of(line, panel_.cursor.caret);
        list_.AddRectFilled({x - 1, y_of(line) + 1}, {x - 1 + std::max(1.0f, theme_.px(2)), y_of(line + 1) - 1}, ink(palette::accent));
    }

    /// A bar beside lines that are not those on disk, a wedge where some went.
    void changes() const {
        const auto& marks = panel_.changes->lines;
        auto mark = std::lower_bound(marks.begin(), marks.end(), first_, [](const LineMark& m, int line) { return m.line < line; });
        for (; mark != marks.end() && mark->line <= last_ + 1; ++mark) {
            const float y = y_of(mark->line), wide = theme_.px(3);
            const bool gone = !mark->removed.empty();
            if (mark->added) list_.AddRectFilled({window_.x, y}, {window_.x + wide, y + height_}, ink(gone ? palette::amber : palette::teal));
            else list_.AddTriangleFilled({window_.x, y - theme_.px(4)}, {window_.x + theme_.px(6), y}, {window_.x, y + theme_.px(4)}, ink(palette::coral));
        }
    }

    void margin() const {
        const float right = window_.x + gutter_;
        list_.AddRectFilled(window_, {right - theme_.px(3), window_.y + inner_.y}, ink(palette::bar));
        const int here = text_.line_column(panel_.cursor.caret).line;
        for (int line = first_; line <= last_; ++line) {
            const std::string number = std::to_string(line);
            const float x = right - theme_.px(9) - advance_ * static_cast<float>(number.size());
            const bool bright = panel_.focused && line == here;
            list_.AddText(theme_.mono, theme_.mono->FontSize, {x, y_of(line) + std::floor(0.5f * (height_ - theme_.mono->FontSize))},
                          ink(bright ? palette::text : palette::faint), number.c_str());
        }
        if (panel_.changes) changes();
        for (const NodeId node : state_.selection.nodes()) {
            const LineRange lines = lines_of_node(node);
            if (lines.last > 0 && lines.last >= first_ && lines.first <= last_)
                list_.AddRectFilled({right - theme_.px(3), y_of(std::max(lines.first, first_))}, {right, y_of(std::min(lines.last, last_) + 1)}, ink(palette::accent));
        }
        for (const SourceMark& mark : marks_) {
            const int line = mark_lines(mark).first;
            if (line >= first_ && line <= last_)
                draw_icon(list_, mark.error ? Icon::error : Icon::warning, {window_.x + theme_.px(10), y_of(line) + 0.5f * height_}, theme_.px(12),
                          ink(mark.error ? palette::coral : palette::amber));
        }
    }

    AppState& state_;
    Ui& ui_;
    SourcePanel& panel_;
    const Theme& theme_;
    const std::vector<SourceMark>& marks_;
    const SourceText& text_;
    ImDrawList& list_;
    float height_, advance_, gutter_ = 0;
    ImVec2 window_, inner_, origin_;
    int first_ = 1, last_ = 1;
};

}  // namespace

void source_lines(AppState& state, Ui& ui, const std::vector<SourceMark>& marks) { Lines(state, ui, marks).draw(); }

float source_line_height(const Theme& theme) { return std::ceil(1.38f * theme.mono->FontSize); }

}  // namespace pinfield::editor
