#include "engine/program/bvh.h"

#include <array>

namespace pinfield {
namespace {

constexpr int leaf_size = 2;
constexpr int bin_count = 8;

bool is_searchable(const Box2& box) { return !box.is_empty() && box.is_finite(); }

Box2 padded(const Box2& box) {
    const double reach = std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff());
    return box.grown(1e-13 * (1 + reach));
}

double half_perimeter(const Box2& box) {
    const Vec2 size = box.size();
    return size.x() + size.y();
}

struct Bin {
    Box2 box;
    int count = 0;
};

/// The border between bins whose two sides cost least: their perimeters (the chance that a search enters) times their entries.
/// 0 when nothing is gained by any.
int best_border(const std::array<Bin, bin_count>& bins) {
    std::array<double, bin_count> right_cost{};
    Bin right;
    for (int b = bin_count - 1; b > 0; --b) {
        const Bin& bin = bins[static_cast<std::size_t>(b)];
        right.box = right.box.merged(bin.box);
        right.count += bin.count;
        right_cost[static_cast<std::size_t>(b)] = right.count == 0 ? infinity : right.count * half_perimeter(right.box);
    }
    Bin left;
    int best = 0;
    double best_cost = infinity;
    for (int b = 1; b < bin_count; ++b) {
        const Bin& bin = bins[static_cast<std::size_t>(b) - 1];
        left.box = left.box.merged(bin.box);
        left.count += bin.count;
        if (left.count == 0) continue;
        const double cost = left.count * half_perimeter(left.box) + right_cost[static_cast<std::size_t>(b)];
        if (cost < best_cost) best_cost = cost, best = b;
    }
    return best;
}

}  // namespace

Bvh::Bvh(std::span<const Box2> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (is_searchable(boxes[i])) order_.push_back(static_cast<int>(i));
        else if (!boxes[i].is_empty()) unbounded_.push_back(static_cast<int>(i));
    }
    if (order_.empty()) return;
    nodes_.reserve(2 * order_.size());
    nodes_.emplace_back();
    split(boxes, 0, 0, static_cast<int>(order_.size()), 1);
}

void Bvh::refit(std::span<const Box2> boxes) {
    const auto still = [&](int entry) { return is_searchable(boxes[static_cast<std::size_t>(entry)]); };
    const bool same_kind = boxes.size() == order_.size() + unbounded_.size() &&
                           std::all_of(order_.begin(), order_.end(), still) &&
                           std::none_of(unbounded_.begin(), unbounded_.end(), still);
    if (!same_kind) {
        *this = Bvh(boxes);
        return;
    }
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // children follow their parents
        TreeNode& node = nodes_[i];
        const auto first = static_cast<std::size_t>(node.first);
        if (node.count == 0) {
            node.box = nodes_[first].box.merged(nodes_[first + 1].box);
            continue;
        }
        node.box = Box2::empty();
        for (std::size_t k = first; k < first + static_cast<std::size_t>(node.count); ++k)
            node.box = node.box.merged(padded(boxes[static_cast<std::size_t>(order_[k])]));
    }
}

/// Surface-area heuristic over bins of centres (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).
void Bvh::split(std::span<const Box2> boxes, std::size_t node, int first, int count, int depth) {
    if (count <= leaf_size) {
        Box2 box;
        for (int i = first; i < first + count; ++i)
            box = box.merged(padded(boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])]));
        nodes_[node] = {box, first, count};
        return;
    }
    const int left_count = static_cast<int>(partition(boxes, first, count, depth));
    const std::size_t left = nodes_.size();
    nodes_.resize(left + 2);
    split(boxes, left, first, left_count, depth + 1);
    split(boxes, left + 1, first + left_count, count - left_count, depth + 1);
    nodes_[node] = {nodes_[left].box.merged(nodes_[left + 1].box), static_cast<int>(left), 0};
}

/// Reorders the entries first ... first + count so that those of the left child come first, each side in its old order;
/// tells how many they are. Halves the list by position where bins cannot tell the entries apart or the tree grows too deep.
std::size_t Bvh::partition(std::span<const Box2> boxes, int first, int count, int depth) {
    const auto entries = std::span(order_).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
    const auto box_of = [&](int entry) -> const Box2& { return boxes[static_cast<std::size_t>(entry)]; };
    Box2 centres;
    for (const int entry : entries) centres = centres.including(box_of(entry).centre());
    const Vec2 spread = centres.size();
    const int axis = spread.y() > spread.x() ? 1 : 0;
    if (!(spread[axis] > 0) || depth > detail::bvh_depth / 2) return entries.size() / 2;

    const double lo = centres.lo[axis], bins_per_metre = bin_count / spread[axis];
    const auto bin_of = [&](int entry) {
        return std::min(static_cast<int>((box_of(entry).centre()[axis] - lo) * bins_per_metre), bin_count - 1);
    };
    std::array<Bin, bin_count> bins;
    for (const int entry : entries) {
        Bin& bin = bins[static_cast<std::size_t>(bin_of(entry))];
        bin.box = bin.box.merged(box_of(entry));
        ++bin.count;
    }
    const int border = best_border(bins);
    std::vector<int> right;
    std::size_t left_count = 0;
    for (const int entry : entries) {
        if (bin_of(entry) < border) entries[left_count++] = entry;
        else right.push_back(entry);
    }
    std::copy(right.begin(), right.end(), entries.begin() + static_cast<std::ptrdiff_t>(left_count));
    return left_count == 0 || right.empty() ? entries.size() / 2 : left_count;
}

}  // namespace pinfield
