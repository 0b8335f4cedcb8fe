#include "editor/source_places.h"

#include <algorithm>

namespace pinfield::editor {

NodeId node_at(const Scene& scene, const Place& place) {
    NodeId best;
    std::size_t length = static_cast<std::size_t>(-1);
    for (const NodeId id : scene.all()) {
        const Place& where = scene.find(id)->where;
        const std::size_t offset = place.span.begin, begin = where.span.begin, end = where.span.end;
        if (where.file == place.file && begin <= offset && offset < end && end - begin < length) {
            best = id;
            length = end - begin;
        }
    }
    return best;
}

NodeId node_of_line(const Scene& scene, int line) {
    const SourceText& source = scene.sources.main();
    const std::string_view text = source.line(line);
    std::size_t word = text.find_first_not_of(" \t");
    while (word != std::string_view::npos && (text.substr(word).starts_with("- ") || text.substr(word).starts_with("-\t")))
        word = text.find_first_not_of(" \t", word + 1);
    if (word == std::string_view::npos) return {};
    const auto begin = static_cast<std::size_t>(text.data() - source.text().data()) + word;
    return node_at(scene, source.place({begin, begin}));
}

LineRange lines_of(const SourceText& text, Span span) {
    const int first = text.line_column(span.begin).line;
    return {first, std::max(first, text.line_column(std::max(span.begin, span.end - (span.end > 0 ? 1 : 0))).line)};
}

}  // namespace pinfield::editor
