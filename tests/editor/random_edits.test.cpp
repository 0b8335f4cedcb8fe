// Any edit of any table in any style: what a person who keeps tables in git relies on.
#include <fmt/format.h>
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <stdexcept>

#include "editor/document.h"
#include "editor/session.h"
#include "engine/core/at.h"
#include "engine/io/same_content.h"
#include "engine/io/yaml_items.h"
#include "engine/program/compile.h"
#include "tests/editor/support.h"
#include "tests/io/random_reuse.h"
#include "tests/io/random_table.h"
#include "tests/io/support.h"
#include "tests/program/same_program.h"

using namespace pinfield;
using namespace pinfield::editor;

namespace {

using Lines = std::set<int>;

bool is_aside(std::string_view line) {
    const std::size_t content = line.find_first_not_of(" \r\t");
    return content == std::string_view::npos || line[content] == '#';
}

/// Which lines of a table an edit may touch.
class Touched {
public:
    explicit Touched(const Scene& scene) : scene_(scene), text_(scene.sources.main()) {}

    Lines of(const Edit& edit) {
        std::visit([&](const auto& e) { add(e); }, edit);
        return std::move(lines_);
    }

private:
    void lines(const Place& place) {
        if (!place) return;
        const int last = text_.line_column(place.span.end > place.span.begin ? place.span.end - 1 : place.span.end).line;
        for (int line = text_.line_column(place.span.begin).line; line <= last; ++line) lines_.insert(line);
    }
    /// With the comments and empty lines around it, which may be its own.
    void whole(const Place& place) {
        if (!place) return;
        Touched own(scene_);
        own.lines(place);
        for (int line = *own.lines_.begin() - 1; line > 0 && is_aside(text_.line(line)); --line) lines_.insert(line);
        for (int line = *own.lines_.rbegin() + 1; line <= text_.line_count() && is_aside(text_.line(line)); ++line) lines_.insert(line);
        lines_.merge(own.lines_);
    }
    void whole(NodeId id) { whole(scene_.find(id)->where); }
    /// Without what its children say in lines of their own.
    void own(NodeId id) {
        const Node& node = *scene_.find(id);
        Touched inner(scene_), all(scene_);
        if (!node.children.empty() && is_item_line(node.children.front()))
            for (const NodeId child : node.children) inner.lines(scene_.find(child)->where);
        all.lines(node.where);
        for (const int line : all.lines_)
            if (!inner.lines_.contains(line)) lines_.insert(line);
    }
    /// An item of a block list, not one between brackets.
    bool is_item_line(NodeId id) const {
        const std::size_t begin = scene_.find(id)->where.span.begin;
        const LineColumn start = text_.line_column(begin);
        const std::string_view line = text_.line(start.line);
        const std::string_view ahead = text_.slice({begin - static_cast<std::size_t>(start.column - 1), begin});
        return line.starts_with(ahead) && ahead.find_first_not_of(" \t") == ahead.find('-') &&
               ahead.find_first_of(":[") == std::string_view::npos;
    }
    /// A list of items in lines of their own takes one more, or one less, and nothing else changes.
    void list_of(NodeId parent, NodeId leaving = {}) {
        std::vector<NodeId> others = scene_.children_of(parent);
        std::erase(others, leaving);
        if (others.empty() && parent) own(parent);
        if (others.empty() && !parent) top_level();
        if (!others.empty() && !is_item_line(others.front()))
            for (const NodeId other : others) lines(scene_.find(other)->where);
        if (!others.empty() && !is_item_line(others.front()) && parent) own(parent);
    }
    void top_level() {
        for (int line = 1; line <= text_.line_count(); ++line)
            if (text_.line(line).find("scene:") != std::string_view::npos) lines_.insert(line);
    }
    void named(const std::string& name) {
        for (int line = 1; line <= text_.line_count(); ++line)
            if (text_.line(line).find(name) != std::string_view::npos) lines_.insert(line);
    }

    void add(const SetField& e) {
        const Node& node = *scene_.find(e.node);
        const FieldSlot& slot = at(node.fields, e.field);
        if (slot.where && e.is_explicit) return lines(slot.where);
        own(e.node);
    }
    void add(const Insert& e) {
        if (e.nodes.front().is_record()) {
            if (scene_.materials().empty())
                named("materials:");
            else
                own(scene_.materials().back());
            return;
        }
        list_of(e.parent);
    }
    void add(const Remove& e) {
        whole(e.node);
        if (scene_.find(e.node)->is_record()) {
            if (scene_.materials().size() == 1) named("materials:");
            return;
        }
        list_of(scene_.find(e.node)->parent, e.node);
    }
    void add(const Move& e) {
        whole(e.node);
        list_of(scene_.find(e.node)->parent, e.node);
        list_of(e.parent, scene_.find(e.node)->parent == e.parent ? e.node : NodeId{});
    }
    void add(const Wrap& e) {
        const auto& among = scene_.children_of(e.parent);
        for (int i = e.first; i < e.first + e.count; ++i) whole(at(among, i));
        list_of(e.parent);
    }
    void add(const Unwrap& e) {
        whole(e.node);
        list_of(scene_.find(e.node)->parent, e.node);
    }
    void add(const Retype& e) { whole(e.node); }
    void add(const Rename& e) {
        if (e.node) own(e.node);
        if (!e.from.empty()) named(e.from);
    }

    void section(const char* key, bool is_empty, int neighbour) {
        if (is_empty) named(key);
        for (const int index : {neighbour, neighbour - 1})
            if (std::string_view(key) == "inputs:" && index >= 0 && index < static_cast<int>(scene_.inputs.size()))
                lines(at(scene_.inputs, index).where);
            else if (index >= 0 && index < static_cast<int>(scene_.tests.size()) && std::string_view(key) == "tests:")
                lines(at(scene_.tests, index).where);
    }
    void add(const InsertInput& e) { section("inputs:", scene_.inputs.empty(), e.index); }
    void add(const RemoveInput& e) { section("inputs:", scene_.inputs.size() == 1, e.index); }
    void add(const SetKeys& e) { lines(at(scene_.inputs, e.index).where); }
    void add(const InsertTest& e) { section("tests:", scene_.tests.empty(), e.index); }
    void add(const RemoveTest& e) {
        section("tests:", scene_.tests.size() == 1, e.index);
        whole(at(scene_.tests, e.index).where);
    }
    void add(const RenameTest& e) { lines(at(scene_.tests, e.index).where); }

    const Scene& scene_;
    const SourceText& text_;
    Lines lines_;
};

/// The first line before the edit, of those it may not touch, that is not there after it, in the order they had; 0: there is none.
int lost_line(const SourceText& before, const SourceText& after, const Lines& may_change) {
    int found = 0;
    for (int line = 1; line <= before.line_count(); ++line) {
        if (may_change.contains(line)) continue;
        do ++found;
        while (found <= after.line_count() && after.line(found) != before.line(line));
        if (found > after.line_count()) return line;
    }
    return 0;
}

/// Each comment, and the lines on which it stands: random tables number them.
std::map<std::string, std::vector<int>> comments_of(const Reading& now) {
    std::map<std::string, std::vector<int>> out;
    const std::string& text = now.source().text();
    if (!now.tree->root) return out;
    for (const Span span : comments_in(text, {0, text.size()}, *now.tree->root))
        out[text.substr(span.begin, span.end - span.begin)].push_back(now.source().line_column(span.begin).line);
    return out;
}

void require(bool law, const std::string& broken) {
    if (!law) throw std::runtime_error(broken);
}

void require_fresh(const Session& session, const Document& document) {
    const auto fresh = compile(document.scene());
    if (!fresh) return;
    const std::string difference = pinfield::test::difference(session.program(), **fresh);
    require(difference.empty(),
            fmt::format("the running program differs in {} from a fresh one of\n{}", difference, document.source().text()));
}

/// A document, the table that runs on it, and all texts it has been.
struct Work {
    Document document;
    Session session;
    std::vector<std::string> texts;
    int done = 0, refused = 0, at_homes = 0;

    explicit Work(const std::string& text) : document(Document::untitled(editor::test::catalog(), text)), session(document), texts{text} {}

    void one_edit(CounterRng& rng);
    void many_edits(CounterRng& rng);
    void one_home_edit(CounterRng& rng);
    void judge(const Scene& expected);
};

std::string name_of(const Edit& edit) {
    static constexpr const char* names[] = {"set", "insert", "remove", "move", "wrap", "unwrap", "retype", "rename",
                                            "insert input", "remove input", "set keys", "insert test", "remove test", "rename test"};
    return names[edit.index()];
}

/// A comment may go with what it stands beside.
bool takes_away(const Edit& edit) {
    const auto* field = std::get_if<SetField>(&edit);
    const auto* name = std::get_if<RenameTest>(&edit);
    return std::holds_alternative<Remove>(edit) || std::holds_alternative<Retype>(edit) || std::holds_alternative<RemoveInput>(edit) ||
           std::holds_alternative<RemoveTest>(edit) || (field && !field->is_explicit) || (name && name->name.empty());
}

void Work::judge(const Scene& expected) {
    require(document.reading().ok() && same_content(document.scene(), expected) && document.scene().all() == expected.all(),
            "the text says another table than was meant:\n" + document.source().text());
    session.follow(document);
    require_fresh(session, document);
    texts.push_back(document.source().text());
    ++done;
}

void Work::one_edit(CounterRng& rng) {
    std::optional<Edit> edit;
    if (rng.next_u64() % 2)
        edit = pinfield::test::some_structural_edit(document.scene(), rng);
    else if (const auto field = pinfield::test::some_edit(document.scene(), rng))
        edit = *field;
    if (!edit) return;
    const Reading before = document.reading();
    Scene expected = document.scene();
    pinfield::apply(expected, *edit);
    const Lines may_change = Touched(before.scene).of(*edit);
    if (document.edit(std::span(&*edit, 1), name_of(*edit))) {
        require(document.source().text() == texts.back(), "a refused edit changed the text");
        ++refused;
        return;
    }
    if (document.source().text() == texts.back()) return;
    judge(expected);
    const auto told = [&](const std::string& what) {
        return fmt::format("{} {}\n--- before\n{}\n--- after\n{}", name_of(*edit), what, before.source().text(), texts.back());
    };
    const int line = lost_line(before.source(), document.source(), may_change);
    require(line == 0, told(fmt::format("changed line {}", line)));
    const auto comments = comments_of(before), later = comments_of(document.reading());
    for (const auto& [comment, lines] : comments)
        if (!later.contains(comment)) require(takes_away(*edit) && may_change.contains(*lines.begin()), told("lost " + comment));
    for (const auto& [comment, lines] : later)
        require(lines.size() == 1 && comments.contains(comment), told("made up " + comment));
}

void Work::many_edits(CounterRng& rng) {
    Scene expected = document.scene();
    std::vector<Edit> edits;
    for (int i = 0; i < 3; ++i)
        if (const auto edit = pinfield::test::some_edit(expected, rng)) {
            pinfield::apply(expected, *edit);
            edits.emplace_back(*edit);
        }
    if (document.edit(edits, "many"))
        ++refused;
    else if (document.source().text() != texts.back())
        judge(expected);
}

/// Values that stand elsewhere: every node keeps what does not come from there.
void require_confined(const Reading& before, const Reading& after, const SetField& edit, const ValueHome& home) {
    for (const NodeId id : before.scene.all()) {
        const Node &was = *before.scene.find(id), &is = *after.scene.find(id);
        for (std::size_t i = 0; i < was.fields.size(); ++i) {
            const bool is_name = was.type->fields[i].meta.meaning == Meaning::id, is_it = id == edit.node && static_cast<int>(i) == edit.field;
            const bool may = is_it || is_name || was.fields[i].written || (home.kind != ValueHome::Kind::own && was.origin);
            require(may || identical(was.fields[i].value, is.fields[i].value),
                    fmt::format("{} of {} changed {}", home.told, before.scene.path(edit.node), before.scene.path(id)));
        }
    }
}

void Work::one_home_edit(CounterRng& rng) {
    const Reading before = document.reading();
    const std::vector<NodeId> all = before.scene.all();
    for (int attempt = 0; attempt < 30; ++attempt) {
        const Node& node = *before.scene.find(all[rng.next_u64() % all.size()]);
        const auto field = static_cast<int>(rng.next_u64() % node.fields.size());
        const FieldType& type = at(node.type->fields, field);
        const SetField edit{node.id, field, pinfield::test::another_value(type, at(node.fields, field).value, rng), true};
        const std::vector<ValueHome> homes = homes_of(before, edit);
        if (homes.empty()) continue;
        const ValueHome& home = homes[rng.next_u64() % homes.size()];
        if (document.edit_home(edit, home, "at home")) {
            require(document.source().text() == texts.back(), "a refused edit changed the text");
            continue;
        }
        document.forget_homes();
        if (document.source().text() == texts.back()) return;
        const auto told = [&](const std::string& what) {
            return fmt::format("{} {} {}: {}\n--- before\n{}\n--- after\n{}", before.scene.path(node.id), type.key, home.told, what, texts.back(),
                               document.source().text());
        };
        const auto comments = comments_of(before), later = comments_of(document.reading());
        for (const auto& [comment, lines] : comments) require(later.contains(comment), told("lost " + comment));
        require(comments.size() == later.size(), told("made up a comment"));
        require_confined(before, document.reading(), edit, home);
        judge(document.scene());
        ++at_homes;
        return;
    }
}

/// So many edits of a table, then back to the beginning and forth again.
Work edited(std::uint64_t seed, int edits) {
    CounterRng rng(seed);
    std::string table = pinfield::test::random_table(rng);
    if (seed % 2) table = pinfield::test::with_reuse(std::move(table), rng);
    Work work(table);
    std::string said;
    for (const Diagnostic& d : work.document.diagnostics()) said += format(d, work.document.diagnosed());
    require(work.document.reading().ok(), "a table that does not read:\n" + said + work.texts.front());
    for (int i = 0; i < edits; ++i) i % 8 == 7 ? work.many_edits(rng) : i % 4 == 2 ? work.one_home_edit(rng) : work.one_edit(rng);
    for (std::size_t i = work.texts.size(); i-- > 0;) {
        require(work.document.source().text() == work.texts[i], "undo does not give back\n" + work.texts[i]);
        require(work.document.can_undo() == (i > 0), "more or fewer steps than edits");
        work.document.undo();
    }
    while (work.document.can_redo()) work.document.redo();
    require(work.document.source().text() == work.texts.back(), "redo does not give back\n" + work.texts.back());
    work.session.follow(work.document);
    require_fresh(work.session, work.document);
    return work;
}

}  // namespace

TEST_CASE("edits of tables in many styles change only the lines they should, lose no comment, and are taken back byte for byte") {
    int done = 0, refused = 0, at_homes = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        INFO(seed);
        const Work work = edited(seed, 40);
        done += work.done;
        refused += work.refused;
        at_homes += work.at_homes;
    }
    CHECK(done > 200);
    CHECK(at_homes > 20);
    CHECK(refused < done / 10);
}

TEST_CASE("any edits of any table in any style change only the lines they should, lose no comment, and are taken back byte for byte",
          "[slow]") {
    int done = 0, refused = 0, at_homes = 0;
    CHECK(rc::check("40 random edits of a random table", [&](std::uint64_t seed) {
        const Work work = edited(seed, 40);
        done += work.done;
        refused += work.refused;
        at_homes += work.at_homes;
    }));
    WARN(done << " edits done, " << at_homes << " of them elsewhere than at the node, " << refused << " refused");
    CHECK(refused < done / 10);
}
