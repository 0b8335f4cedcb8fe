#include "engine/program/bvh.h"

#include <array>
#include <cmath>

#include "engine/core/at.h"

namespace pinfield {
namespace {

constexpr int leaf_size = 4;
constexpr int bin_count = 8;

bool is_searchable(const Box2& box) { return !box.is_empty() && box.is_finite(); }

/// A plain box: the build merges thousands, and corners one by one beat vectors here.
struct Extent {
    double lo[2] = {infinity, infinity}, hi[2] = {-infinity, -infinity};

    void add(const Extent& e) {
        for (int axis : {0, 1}) {
            lo[axis] = std::min(lo[axis], e.lo[axis]);
            hi[axis] = std::max(hi[axis], e.hi[axis]);
        }
    }
    double half_perimeter() const { return hi[0] - lo[0] + hi[1] - lo[1]; }
};

struct Entry {
    Extent extent;
    double centre[2];
    int id, bin;
};

struct Bin {
    Extent extent;
    int count = 0;
    void add(const Bin& b) {
        extent.add(b.extent);
        count += b.count;
    }
    double cost() const { return count == 0 ? infinity : count * extent.half_perimeter(); }
};

Bvh::TreeNode node_around(const Extent& e, int first, int count) {
    const double reach = std::max({std::fabs(e.lo[0]), std::fabs(e.lo[1]), std::fabs(e.hi[0]), std::fabs(e.hi[1])});
    const double room = 2.5e-7 * reach + 1e-12;  // four roundings of a float
    return {static_cast<float>(e.lo[0] - room),
            static_cast<float>(e.lo[1] - room),
            static_cast<float>(e.hi[0] + room),
            static_cast<float>(e.hi[1] + room),
            first,
            count};
}

/// The border between bins whose two sides cost least: their perimeters (the chance that a search enters) times their
/// entries.
int best_border(const std::array<Bin, bin_count>& bins) {
    std::array<double, bin_count> right_cost{};
    Bin right;
    for (std::size_t b = bin_count - 1; b > 0; --b) {
        right.add(bins[b]);
        right_cost[b] = right.cost();
    }
    Bin left;
    std::size_t best = 0;
    double best_cost = infinity;
    for (std::size_t b = 1; b < bin_count; ++b) {
        left.add(bins[b - 1]);
        const double cost = left.cost() + right_cost[b];
        if (cost < best_cost) best_cost = cost, best = b;
    }
    return static_cast<int>(best);
}

/// Surface-area heuristic over bins of centres (Wald, "On fast construction of SAH-based bounding volume hierarchies",
/// 2007).
class Builder {
public:
    Builder(std::vector<Entry>& entries, std::vector<Bvh::TreeNode>& nodes) : entries_(entries), nodes_(nodes) {
        others_.resize(entries.size());
        nodes_.reserve(entries.size());
        nodes_.emplace_back();
        split(0, 0, entries.size(), 1);
    }

private:
    void split(std::size_t node, std::size_t first, std::size_t count, int depth) {
        Extent extent, centres;
        for (std::size_t i = first; i < first + count; ++i) {
            const Entry& e = entries_[i];
            extent.add(e.extent);
            centres.add({{e.centre[0], e.centre[1]}, {e.centre[0], e.centre[1]}});
        }
        if (count <= leaf_size) {
            nodes_[node] = node_around(extent, static_cast<int>(first), static_cast<int>(count));
            return;
        }
        const std::size_t left_count = partition(centres, first, count, depth), left = nodes_.size();
        nodes_[node] = node_around(extent, static_cast<int>(left), 0);
        nodes_.resize(left + 2);
        split(left, first, left_count, depth + 1);
        split(left + 1, first + left_count, count - left_count, depth + 1);
    }

    /// Reorders the entries so that those of the left child come first, each side in its old order; returns how many they
    /// are. Halves the list by position where bins cannot tell the entries apart or the tree grows too deep.
    std::size_t partition(const Extent& centres, std::size_t first, std::size_t count, int depth) {
        const double spread[] = {centres.hi[0] - centres.lo[0], centres.hi[1] - centres.lo[1]};
        const int axis = spread[1] > spread[0] ? 1 : 0;
        if (!(spread[axis] > 0) || depth > detail::bvh_depth / 2) return count / 2;
        const double bins_per_metre = bin_count / spread[axis];
        std::array<Bin, bin_count> bins;
        for (std::size_t i = first; i < first + count; ++i) {
            Entry& e = entries_[i];
            e.bin = std::min(static_cast<int>((e.centre[axis] - centres.lo[axis]) * bins_per_metre), bin_count - 1);
            at(bins, e.bin).add({e.extent, 1});
        }
        const int border = best_border(bins);
        std::size_t left_count = 0, right_count = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            if (entries_[i].bin < border)
                entries_[first + left_count++] = entries_[i];
            else
                others_[right_count++] = entries_[i];
        }
        std::copy_n(others_.begin(), right_count, entries_.begin() + static_cast<std::ptrdiff_t>(first + left_count));
        return left_count == 0 || right_count == 0 ? count / 2 : left_count;
    }

    std::vector<Entry>& entries_;
    std::vector<Bvh::TreeNode>& nodes_;
    std::vector<Entry> others_;
};

Extent extent_of(const Box2& box) { return {{box.lo.x(), box.lo.y()}, {box.hi.x(), box.hi.y()}}; }

}  // namespace

Bvh::Bvh(std::span<const Box2> boxes) {
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box2& box = boxes[i];
        const int id = static_cast<int>(i);
        if (is_searchable(box))
            entries.push_back({extent_of(box), {box.centre().x(), box.centre().y()}, id, 0});
        else if (!box.is_empty())
            unbounded_.push_back(id);
    }
    if (entries.empty()) return;
    Builder(entries, nodes_);
    order_.reserve(entries.size());
    for (const Entry& e : entries) order_.push_back(e.id);
}

}  // namespace pinfield
