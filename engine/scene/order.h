// Lists whose items were moved, put in and taken out: what kept its place, and two such changes of one list made one.
#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace pinfield {

/// Of the keys that are in both, the most that stand in the same order: those that were not moved.
template <class Key>
std::set<Key> unmoved(const std::vector<Key>& before, const std::vector<Key>& now) {
    std::map<Key, std::size_t> place;
    for (std::size_t i = 0; i < before.size(); ++i) place.emplace(before[i], i);
    struct Run {
        std::size_t last = 0, previous = 0;  ///< of `runs`, which begins with none
        Key key{};
    };
    std::vector<Run> runs(1);
    std::vector<std::size_t> ends;  // of the best increasing run of each length, the one that ends lowest
    for (const Key& key : now) {
        const auto at = place.find(key);
        if (at == place.end()) continue;
        const auto longer =
            std::lower_bound(ends.begin(), ends.end(), at->second, [&](std::size_t run, std::size_t p) { return runs[run].last < p; });
        runs.push_back({at->second, longer == ends.begin() ? 0 : *(longer - 1), key});
        if (longer == ends.end())
            ends.push_back(runs.size() - 1);
        else
            *longer = runs.size() - 1;
    }
    std::set<Key> out;
    for (std::size_t run = ends.empty() ? 0 : ends.back(); run != 0; run = runs[run].previous) out.insert(runs[run].key);
    return out;
}

/// One list of two that were changed from `base`; all that either holds is in it. What one side moved or put in stands where that side has
/// it: behind the same unmoved key. Of what both put there, `less(one of mine, one of theirs)` says which comes first.
/// `chooses_mine(key)` is asked where both moved a key, each elsewhere.
template <class Key, class Less, class Choose>
std::vector<Key> merged_order(const std::vector<Key>& base, const std::vector<Key>& mine, const std::vector<Key>& theirs, Less less,
                              Choose chooses_mine) {
    const std::set<Key> kept_by_me = unmoved(base, mine), kept_by_them = unmoved(base, theirs);
    using Gap = std::optional<Key>;  // behind this one; none: at the front
    const auto gaps_of = [&](const std::vector<Key>& list) {
        std::map<Key, Gap> gaps;
        Gap behind;
        for (const Key& key : list) {
            if (kept_by_me.contains(key) && kept_by_them.contains(key))
                behind = key;
            else
                gaps.emplace(key, behind);
        }
        return gaps;
    };
    const std::map<Key, Gap> my_gaps = gaps_of(mine), their_gaps = gaps_of(theirs);
    std::set<Key> placed_by_me;
    for (const auto& [key, gap] : my_gaps) {
        const auto there = their_gaps.find(key);
        const bool only_mine = there == their_gaps.end() || (kept_by_them.contains(key) && !kept_by_me.contains(key));
        const bool both = !only_mine && kept_by_me.contains(key) == kept_by_them.contains(key) && there->second != gap;
        if (only_mine || (both && chooses_mine(key))) placed_by_me.insert(key);
    }
    std::map<Gap, std::pair<std::vector<Key>, std::vector<Key>>> groups;
    for (const Key& key : mine)
        if (placed_by_me.contains(key)) groups[my_gaps.at(key)].first.push_back(key);
    for (const Key& key : theirs)
        if (their_gaps.contains(key) && !placed_by_me.contains(key)) groups[their_gaps.at(key)].second.push_back(key);
    std::vector<Key> out;
    const auto fill = [&](const Gap& gap) {
        auto& [ours, others] = groups[gap];
        const bool mine_first = !ours.empty() && !others.empty() && less(ours.front(), others.front());
        for (const auto* group : {mine_first ? &ours : &others, mine_first ? &others : &ours})
            out.insert(out.end(), group->begin(), group->end());
    };
    fill({});
    for (const Key& key : base)
        if (kept_by_me.contains(key) && kept_by_them.contains(key)) out.push_back(key), fill(key);
    return out;
}

}  // namespace pinfield
