#include "engine/scene/match.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/common_sequence.h"

namespace pinfield {
namespace {

using Nodes = std::vector<NodeId>;

class Matching {
public:
    Matching(const Scene& before, const Scene& now) : before_(before), now_(now) {}

    std::map<NodeId, NodeId> run() && {
        pair(before_.table().id, now_.table().id);
        pair(before_.physics().id, now_.physics().id);
        pair_names();
        align(before_.materials(), now_.materials());
        align(before_.roots(), now_.roots());
        for (const NodeId id : now_.all())  // parents come before their children
            if (const auto known = of_now_.find(id); known != of_now_.end()) align(old(known->second).children, young(id).children);
        pair_moved();
        return std::move(of_now_);
    }

private:
    const Node& old(NodeId id) const { return *before_.find(id); }
    const Node& young(NodeId id) const { return *now_.find(id); }
    bool is_free(NodeId before, NodeId now) const { return !of_before_.contains(before) && !of_now_.contains(now); }
    bool are_paired(NodeId before, NodeId now) const {
        const auto found = of_before_.find(before);
        return found != of_before_.end() && found->second == now;
    }
    void pair(NodeId before, NodeId now) {
        of_before_.emplace(before, now);
        of_now_.emplace(now, before);
    }

    void pair_names() {
        std::map<std::pair<bool, std::string>, NodeId> named;
        for (const NodeId id : before_.all())
            if (!old(id).name.empty()) named.emplace(std::pair(old(id).is_record(), old(id).name), id);
        for (const NodeId id : now_.all()) {
            const auto found = named.find({young(id).is_record(), young(id).name});
            if (!young(id).name.empty() && found != named.end() && is_free(found->second, id)) pair(found->second, id);
        }
    }

    bool are_alike(NodeId before, NodeId now) const { return is_free(before, now) && same_node(before_, old(before), now_, young(now)); }

    /// What two nodes of one type say alike, and what either says at all: fields and, as one each, children.
    std::pair<int, int> likeness(const Node& a, const Node& b) const {
        int alike = 0, said = static_cast<int>(std::max(a.children.size(), b.children.size()));
        for (std::size_t i = 0; i < a.fields.size(); ++i) {
            if (a.type->fields[i].meta.meaning == Meaning::id || (!a.fields[i].is_explicit && !b.fields[i].is_explicit)) continue;
            ++said;
            alike += identical(a.fields[i].value, b.fields[i].value);
        }
        for (std::size_t i = 0; i < std::min(a.children.size(), b.children.size()); ++i)
            alike += same_node(before_, old(a.children[i]), now_, young(b.children[i]));
        return {alike, said};
    }

    /// The children of nodes that are paired: first what is the same in both, as much of it as keeps its order, then what is between.
    void align(const Nodes& x, const Nodes& y) {
        std::size_t i = 0, j = 0;
        const auto gap = [](const Nodes& list, std::size_t& next, std::size_t end) {
            const auto begin = list.begin() + static_cast<std::ptrdiff_t>(std::exchange(next, end + 1));
            return Nodes(begin, list.begin() + static_cast<std::ptrdiff_t>(end));
        };
        auto pairs = common_sequence(x.size(), y.size(),
                                     [&](std::size_t a, std::size_t b) { return are_paired(x[a], y[b]) || are_alike(x[a], y[b]); });
        for (const auto& [a, b] : pairs)
            if (is_free(x[a], y[b])) pair(x[a], y[b]);
        pairs.emplace_back(x.size(), y.size());
        for (const auto& [a, b] : pairs) {
            const Nodes between = gap(x, i, a);
            fill(between, gap(y, j, b));
        }
    }

    /// Between two that are the same: nodes without an id by type and order, the likest first; others where they say mostly the same.
    void fill(const Nodes& x, const Nodes& y) {
        for (const bool named : {false, true}) {
            std::size_t next = 0;
            for (const NodeId b : y) {
                std::size_t best = x.size();
                int most = -1;
                for (std::size_t i = next; i < x.size(); ++i) {
                    if (!is_free(x[i], b) || old(x[i]).type->key() != young(b).type->key()) continue;
                    const bool has_name = !old(x[i]).name.empty() || !young(b).name.empty();
                    const auto [alike, said] = likeness(old(x[i]), young(b));
                    if (has_name != named || (named && (alike == 0 || 2 * alike < said)) || alike <= most) continue;
                    best = i;
                    most = alike;
                }
                if (best == x.size()) continue;
                pair(x[best], b);
                next = best + 1;
            }
        }
    }

    /// What is the same, elsewhere.
    void pair_moved() {
        Nodes left;
        for (const NodeId id : before_.all())
            if (!of_before_.contains(id)) left.push_back(id);
        for (const NodeId id : now_.all()) {
            const auto found = std::find_if(left.begin(), left.end(), [&](NodeId other) { return are_alike(other, id); });
            if (found != left.end()) pair_all(*found, id);
        }
    }

    void pair_all(NodeId before, NodeId now) {
        if (is_free(before, now)) pair(before, now);
        for (std::size_t i = 0; i < old(before).children.size(); ++i) pair_all(old(before).children[i], young(now).children[i]);
    }

    const Scene &before_, &now_;
    std::map<NodeId, NodeId> of_now_, of_before_;
};

}  // namespace

std::map<NodeId, NodeId> match(const Scene& before, const Scene& now) { return Matching(before, now).run(); }

}  // namespace pinfield
