#include "tests/io/support.h"

#include <cmath>
#include <string_view>

namespace pinfield::test {
namespace {

/// Every way to write a map, a list and a text that an author may have picked up.
constexpr std::string_view styles = R"(# a comment first
pinfield: 1   # the version
table:
  name: 'Ünïcode: it''s "quoted"'
  author: "Ada \"L\" \u00e9"   # a comment after a value
  size: [ 0.52 , 1.06 ]
materials:
  rubber: {restitution: 0.80, color: crimson,}   # trailing comma
  goo:
    restitution: .5
    color: "#7c5"  # a color, and # a hash
  bare:
  mixed: {
    restitution: 0.9,   # one entry a line
    friction: 0.30,

    # a comment of its own
    color: '#abcdef'
  }
  short: { friction: 1e-1 }
scene:
- circle:
- circle:   # nothing yet
- circle: ~
- circle: {}
- {circle: {radius: 24mm, at: [1cm, -2.50in]}}
- box: {size: [28mm, 12mm], round: "2mm", note: 'it''s, a box'}
- half_plane: {}
- group:
    id: walls
    note: |
      several
        lines
    # about the children
    children:
    - union:
        children:
          - circle: {radius: 0.5rad, visible: false}
          - box: {
              size: [1.0, 2.0],
              turn: 0.5rad  # radians
            }
    - union: {id: u, children: [circle: {radius: 3cm}, {box: {size: [1, 1]}}, complement: {children: [circle: {}]}], turn: 30deg}
- polygon: {points: [[0, 0], [24mm, 0], [0, 1cm]]}
- polygon:
    points:
      - [0, 0]
      - [1.50, 0]   # the tip
      - [0,
         1.25]
- flipper:
    input: [left, right]
    layer: ground
    rest: -30
    mass: 80g
- flipper: {input: left, layer: [ground, upper]}
inputs: {left: [Z, LeftShift], right: Slash}
tests:
  - {launch: {at: [0.11, 40cm], velocity: [0, 3]}, run: 300ms, expect: [escaped == 0, walls.hits >= 0]}
  - name: two balls
    launch:
      - {at: [0.1, 0.1]}
      - {at: [0.2, 0.1]}
    expect: drained <= 2
  - inputs:
      left: [100ms, 0.2, 1s]  # a tap, then held
      right: 50ms
    expect: drained <= 2
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

double another_number(const FieldMeta& meta, double x, CounterRng& rng) {
    const double lo = std::isfinite(meta.min.value) ? meta.min.value : -2,
                 hi = std::isfinite(meta.max.value) ? std::fmin(meta.max.value, lo + 10) : lo + 4;
    switch (rng.next_u64() % 6) {
        case 0: return x + 0.001;
        case 1: return std::round(rng.in(lo, hi) * 1000) / 1000;
        case 2: return rng.in(lo, hi);
        case 3: return x * 1.5;
        case 4: return x + rng.in(-1e-9, 1e-9);
        default: return hi;
    }
}

constexpr std::string_view words[] = {"plain",      "two words", "with: colon", "a #hash",   " padded ",    "it's",
                                      "\"quoted\"", "[list]",    "naïve ☃",     "null",      "~",           "",
                                      "-dash",      "1e3",       "line\nbreak", "tab\t",     "back\\slash", "a, b",
                                      "*star",      "&and",      "%",           "trailing:", "x: y",        "yes"};
constexpr std::string_view formulas[] = {"x", "x - 2mm", "length(x, y) - 2cm", "max(abs(x), abs(y)) - 1cm", "-y", "floor(x / 1cm) * 1cm"};

}  // namespace

std::vector<std::pair<std::string, std::string>> good_tables() {
    std::vector<std::pair<std::string, std::string>> out;
    for (const char* folder : {"tables", "nodes"})
        for (const auto& path : scene_files(folder)) out.emplace_back(path.filename().string(), file_text(path));
    const std::string text = replaced(std::string(styles), "radius: 0.5rad", "radius: 0.5");
    out.emplace_back("styles", text);
    out.emplace_back("styles with CRLF", replaced(text, "\n", "\r\n"));
    out.emplace_back("styles with a byte order mark", "\xEF\xBB\xBF" + text);
    out.emplace_back("styles without a last line break", text.substr(0, text.size() - 1));
    out.emplace_back("all in flow style",
                     "{pinfield: 1, table: {}, scene: [circle: {radius: 3}, {box: {id: b}}, {half_plane: }]}");
    return out;
}

Value another_value(const FieldType& field, const Value& value, CounterRng& rng) {
    switch (field.kind) {
        case FieldKind::boolean: return !std::get<bool>(value);
        case FieldKind::integer:
            return std::get<std::int64_t>(value) + static_cast<std::int64_t>(rng.next_u64() % 5) - 1;
        case FieldKind::number: return another_number(field.meta, std::get<double>(value), rng);
        case FieldKind::vec2: {
            Vec2 pair = std::get<Vec2>(value);
            const auto which = rng.next_u64() % 3;
            if (which != 0) pair.x() = another_number(field.meta, pair.x(), rng);
            if (which != 1) pair.y() = another_number(field.meta, pair.y(), rng);
            return pair;
        }
        case FieldKind::points: {
            auto points = std::get<std::vector<Vec2>>(value);
            const std::size_t at = points.empty() ? 0 : rng.next_u64() % points.size();
            const auto what = rng.next_u64() % 3;
            if (what == 0 || points.empty())
                points.insert(points.begin() + static_cast<std::ptrdiff_t>(at), Vec2(rng.in(-1, 1), 0.25));
            else if (what == 1 && points.size() > 3)
                points.erase(points.begin() + static_cast<std::ptrdiff_t>(at));
            else
                points[at].x() += 0.001;
            return points;
        }
        case FieldKind::choice: return std::string(field.choices[rng.next_u64() % field.choices.size()]);
        case FieldKind::choices: {
            std::vector<std::string> out(rng.next_u64() % 4);
            for (std::string& word : out) word = field.choices[rng.next_u64() % field.choices.size()];
            return out;
        }
        case FieldKind::text:
            if (field.meta.meaning == Meaning::formula) return std::string(formulas[rng.next_u64() % std::size(formulas)]);
            return std::string(words[rng.next_u64() % std::size(words)]);
        case FieldKind::color: return std::string(rng.next_u64() % 2 ? "#0a1b2c" : "gold");
        case FieldKind::id: return std::string("name_") + std::to_string(rng.next_u64() % 100);
        case FieldKind::names: return std::vector<std::string>(rng.next_u64() % 4, "upper");
    }
    return value;
}

std::optional<SetField> some_edit(const Scene& scene, CounterRng& rng) {
    const std::vector<NodeId> all = scene.all();
    for (int attempt = 0; attempt < 20; ++attempt) {
        const Node& node = *scene.find(all[rng.next_u64() % all.size()]);
        const auto index = static_cast<std::size_t>(rng.next_u64() % node.fields.size());
        const FieldType& field = node.type->fields[index];
        const FieldSlot& slot = node.fields[index];
        // What refers to other things of the file is not free to be anything.
        const bool is_reference =
            field.meta.meaning == Meaning::material || field.meta.meaning == Meaning::input;
        const bool leave_out = slot.is_explicit && identical(slot.value, field.initial) && rng.next_u64() % 2;
        SetField edit{node.id, static_cast<int>(index),
                  leave_out || is_reference ? slot.value : another_value(field, slot.value, rng), !leave_out};
        if (is_reference || why_invalid(scene, edit)) continue;
        return edit;
    }
    return {};
}

}  // namespace pinfield::test
