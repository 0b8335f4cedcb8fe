// Values that the text does not say at a node of their own: in a template, at an item that is copied, as an expression. Where each may be
// changed, and the change.
#pragma once
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/io/table_reader.h"
#include "engine/io/text_patch.h"
#include "engine/scene/edit.h"

namespace pinfield {

/// A place of the text that a field's value comes from.
struct ValueHome {
    enum class Kind : unsigned char {
        line,      ///< where the field stands: in a template's node, at an item with copies, or at the node, in place of an expression
        argument,  ///< of the `use` that made the node
        param,
        own        ///< the node's own line, once what made it is written out
    };
    Kind kind = Kind::line;
    std::string name;   ///< of the argument or param; of the item that is written out
    std::string told;   ///< "in the template gear"
    int values = 1;     ///< that come from there, this one included
};

/// Is the value one that SetField cannot change, since it stands elsewhere or as an expression?
bool stands_elsewhere(const Scene& scene, const SetField& edit);

/// Where it may be changed, the nearest first; none where the field stands at the node itself as a plain value, or in another file.
std::vector<ValueHome> homes_of(const Reading& now, const SetField& edit);

/// The text changed there so that the field has this value, as near as its numbers are written (1 nm at a line, 1 um in a param or
/// argument), and the table read again: nothing has changed but values that come from there. Nodes keep their ids; from `own`, names with
/// dots become plain ones, here and in the tests. Fails where no number there gives the value.
Result<PatchedText> patch_home(const Reading& now, const SetField& edit, const ValueHome& home, const Limits& limits = {});

/// The node that the author's own item is which made this one, or itself; null: its own lines make it.
const Node* maker_of(const Scene& scene, NodeId node);

/// What the node's maker made written out in its place, numbers and all: an item that says `use`, `copies` or `pair` becomes a group. The
/// scene is the same but for the names. `node`: the item's, or one that it made.
Result<PatchedText> patch_written_out(const Reading& now, NodeId node, const Limits& limits = {});

}  // namespace pinfield
