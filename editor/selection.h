// What is selected: nodes in the order in which they were chosen. The last is the one that panels show.
#pragma once
#include <algorithm>
#include <vector>

#include "engine/core/id.h"

namespace pinfield::editor {

class Selection {
public:
    Selection() = default;
    explicit Selection(std::vector<NodeId> nodes) : nodes_(std::move(nodes)) {}

    const std::vector<NodeId>& nodes() const { return nodes_; }
    bool empty() const { return nodes_.empty(); }
    /// The one chosen last, or none.
    NodeId primary() const { return nodes_.empty() ? NodeId{} : nodes_.back(); }
    bool contains(NodeId node) const { return std::find(nodes_.begin(), nodes_.end(), node) != nodes_.end(); }

    /// This node alone; none: nothing.
    void set(NodeId node) {
        nodes_.clear();
        if (node) nodes_.push_back(node);
    }
    /// Adds a node, or takes it out.
    void toggle(NodeId node) {
        const auto there = std::find(nodes_.begin(), nodes_.end(), node);
        if (there != nodes_.end()) nodes_.erase(there);
        else if (node) nodes_.push_back(node);
    }
    template <class Predicate>
    void drop_if(Predicate predicate) {
        nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), predicate), nodes_.end());
    }

private:
    std::vector<NodeId> nodes_;
};

}  // namespace pinfield::editor
