// A table in one file, and the same dealt to several at random, which include each other.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/rng.h"

namespace pinfield::test {

/// What the sections of a table hold, an entry a line: "gap: 2cm", "- circle: {}".
struct TableEntries {
    std::vector<std::pair<std::string, std::vector<std::string>>> sections;
    std::string of_the_whole;  ///< sections that only the table's own file may have
};

struct SplitTable {
    std::string main;
    std::map<std::string, std::string> files;
};

inline std::string in_one(const TableEntries& table) {
    std::string out = "pinfield: 1\n" + table.of_the_whole;
    for (const auto& [section, entries] : table.sections) {
        if (!entries.empty()) out += section + ":\n";
        for (const std::string& entry : entries) out.append("  ").append(entry).append("\n");
    }
    return out;
}

/// Deals entries to files such that each section's, in the order in which the files are read, are in the order they had.
class Dealer {
public:
    explicit Dealer(CounterRng& rng) : rng_(rng) {}

    SplitTable deal(const TableEntries& table) {
        const std::size_t count = 1 + pick(8);
        paths_ = {"table.yaml"};
        includes_.assign(count, {});
        for (std::size_t file = 1; file < count; ++file) {
            const char* folders[] = {"", "parts/", "parts/deep/", "other/"};
            paths_.push_back(fmt::format("{}p{}.yaml", folders[pick(4)], file));
            includes_[pick(file)].push_back(file);
            for (std::size_t more = pick(3); more > 0; --more) includes_[pick(file)].push_back(file);
        }
        order_.clear();
        visit(0);
        std::vector<std::vector<std::string>> sections(count);
        for (const auto& [section, entries] : table.sections) deal(section, entries, sections);
        SplitTable out;
        for (std::size_t file = 0; file < count; ++file) {
            if (const std::string list = include_list(file); !list.empty()) sections[file].push_back(list);
            if (file == 0) sections[file].push_back(table.of_the_whole);
            std::string text = "pinfield: 1\n";
            for (auto& lines = sections[file]; !lines.empty();) {
                const std::size_t next = pick(lines.size());
                text += lines[next];
                lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
            }
            (file == 0 ? out.main : out.files[paths_[file]]) = text;
        }
        return out;
    }

private:
    std::size_t pick(std::size_t n) { return static_cast<std::size_t>(rng_.next_u64() % n); }

    void visit(std::size_t file) {
        if (std::find(order_.begin(), order_.end(), file) != order_.end()) return;
        for (const std::size_t included : includes_[file]) visit(included);
        order_.push_back(file);
    }

    void deal(const std::string& section, const std::vector<std::string>& entries, std::vector<std::vector<std::string>>& out) {
        std::vector<std::size_t> cuts{0, entries.size()};
        for (std::size_t i = 1; i < order_.size(); ++i) cuts.push_back(pick(entries.size() + 1));
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i < order_.size(); ++i) {
            std::string lines;
            for (std::size_t entry = cuts[i]; entry < cuts[i + 1]; ++entry) lines.append("  ").append(entries[entry]).append("\n");
            if (!lines.empty()) out[order_[i]].push_back(fmt::format("{}:\n{}", section, lines));
        }
    }

    std::string include_list(std::size_t file) {
        std::string out;
        const auto depth = static_cast<std::size_t>(std::count(paths_[file].begin(), paths_[file].end(), '/'));
        for (const std::size_t included : includes_[file]) {
            std::string path;
            for (std::size_t up = 0; up < depth; ++up) path += "../";
            const char* detours[] = {"", "./", "x/../", "parts/.././"};
            out += fmt::format("{}{}{}{}", out.empty() ? "" : ", ", path, detours[pick(4)], paths_[included]);
        }
        return out.empty() ? out : fmt::format("include: [{}]\n", out);
    }

    CounterRng& rng_;
    std::vector<std::string> paths_;                  ///< the table's own first
    std::vector<std::vector<std::size_t>> includes_;  ///< of each file
    std::vector<std::size_t> order_;                  ///< in which they are read
};

/// A table with most of what tables have, in entries that need each other across sections and within them; some of them at random.
inline TableEntries some_entries(CounterRng& rng) {
    const auto some = [&](std::vector<std::string> always, const std::vector<std::string>& perhaps) {
        for (const std::string& entry : perhaps)
            if (rng.uniform() < 0.6) always.push_back(entry);
        return always;
    };
    TableEntries out;
    out.sections.emplace_back("params", some({"r: 2 * gap", "gap: {value: 21mm, min: 1cm, label: Gap}", "n: 3"}, {"far: r * 4", "t: n * 10"}));
    out.sections.emplace_back("materials", some({"rubber: {restitution: 0.8}", "steel: {friction: 0.1}"}, {"goo: {}", "wood: {color: tan}"}));
    out.sections.emplace_back("templates", some({"lamp: {args: {w: gap, skin: rubber}, nodes: [circle: {id: bulb, radius: w / 3, material: $skin}]}",
                                                 "row: {args: {k: }, nodes: [use: {template: lamp, id: l, with: {w: r / 2}, copies: {count: k, step: [gap, 0]}}]}"},
                                                {"unseen: {nodes: [box: {size: [r, gap]}]}"}));
    out.sections.emplace_back("scene", some({"- use: {template: row, id: first, at: [0.1, 0.5], with: {k: n}}", "- flipper: {id: bat, at: [0.2, 0.1], input: [left, right], pair: 0.26}"},
                                            {"- circle: {radius: r, material: steel, at: [gap * i, 0.9], copies: {count: n, step: [0, gap]}}",
                                             "- union: {id: u, children: [circle: {radius: gap}, box: {size: [r, r / 2], turn: n}]}",
                                             "- use: {template: lamp, id: lone, with: {skin: steel}, turn: 30}",
                                             "- group: {id: g, material: rubber, children: [circle: {radius: \"min(r, gap)\"}, ring: {}]}",
                                             "- spawn: {id: ball, at: [0.3, 0.9]}", "- box: {size: [gap, 3 * gap], at: [0.4, r]}"}));
    out.sections.emplace_back("inputs", some({"left: [Z, LeftShift]", "right: Slash"}, {"more: X"}));
    out.of_the_whole = "table: {name: Split, size: [0.5, 1]}\ntests: [{run: 1s, expect: [first.l.2.bulb.hits == 0, bat.left.hits == 0]}]\n";
    return out;
}

}  // namespace pinfield::test
