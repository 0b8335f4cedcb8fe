#include "engine/core/source_text.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/core/at.h"

namespace pinfield {

SourceText::SourceText(std::string name, std::string text, FileId file)
    : name_(std::move(name)), text_(std::move(text)), file_(file) {
    line_starts_.reserve(1 + static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')));
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n') line_starts_.push_back(i + 1);
}

LineColumn SourceText::line_column(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
    const std::size_t start = *(next - 1);
    // A byte of the form 10xxxxxx continues a code point; every other byte starts one.
    const auto starts_code_point = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    std::size_t from = start;
    if (start == 0 && std::string_view(text_).starts_with("\xEF\xBB\xBF")) from = std::min<std::size_t>(3, offset);
    const auto count = std::count_if(text_.begin() + static_cast<std::ptrdiff_t>(from),
                                     text_.begin() + static_cast<std::ptrdiff_t>(offset), starts_code_point);
    return {static_cast<int>(next - line_starts_.begin()), static_cast<int>(count) + 1};
}

std::string_view SourceText::line(int n) const {
    if (n < 1 || n > line_count()) return {};
    const std::size_t begin = at(line_starts_, n - 1);
    std::size_t end = n < line_count() ? at(line_starts_, n) - 1 : text_.size();
    if (end > begin && text_[end - 1] == '\r') --end;
    return std::string_view(text_).substr(begin, end - begin);
}

const SourceText* Sources::find(const Place& place) const {
    if (!place || place.file.value > texts_.size()) return nullptr;
    return texts_[place.file.value - main_file.value].get();
}

void Sources::add(std::shared_ptr<const SourceText> text, std::string path, const Place& asked_at) {
    assert(text->file() == next_file() && "texts are numbered in their order");
    texts_.push_back(std::move(text));
    included_.push_back({std::move(path), asked_at});
}

const Sources::Included* Sources::inclusion(FileId file) const {
    if (file.value <= main_file.value || file.value > texts_.size()) return nullptr;
    return &included_[file.value - main_file.value - 1];
}

LineColumn Sources::line_column(const Place& place) const {
    const SourceText* text = find(place);
    return text ? text->line_column(place.span.begin) : LineColumn{};
}

std::string_view Sources::slice(const Place& place) const {
    const SourceText* text = find(place);
    return text ? text->slice(place.span) : std::string_view();
}

std::string Sources::line_from(const Place& here, const Place& place) const {
    const std::string line = std::to_string(line_column(place).line);
    const SourceText* text = find(place);
    return !text || here.file == place.file ? "line " + line : text->name() + ":" + line;
}

}  // namespace pinfield
