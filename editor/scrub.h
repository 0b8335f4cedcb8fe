// A number dragged sideways, in one node or in several at once. No window, no ImGui.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "editor/shared_fields.h"

namespace pinfield::editor {

/// A number being changed by dragging it sideways: one step a pixel (an integer: one in eight). Several nodes change by as many steps, each
/// from where it stood.
class Scrub {
public:
    bool active() const { return !held_.empty(); }
    NodeId node() const { return active() ? held_.front().of.node : NodeId{}; }
    int field() const { return active() ? held_.front().of.field : 0; }
    bool begin(const Document& document, std::span<const FieldOf> fields, int component = 0);
    /// `pixels` since the begin; fine: a tenth, coarse: ten times. Never leaves what why_invalid() allows: each stops at the last
    /// value on its way that is valid.
    void update(Document& document, double pixels, bool fine = false, bool coarse = false);
    std::optional<std::string> end(Document& document);
    void cancel(Document& document);

private:
    struct Held {
        FieldOf of;
        Value before;
    };
    std::vector<Held> held_;
    int component_ = 0;
};

}  // namespace pinfield::editor
