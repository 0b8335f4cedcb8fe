// Two texts of a table that were made of one, made one again: what they say by node and field, how they say it by lines.
#pragma once
#include <string>
#include <vector>

#include "engine/io/table_reader.h"
#include "engine/scene/merge.h"

namespace pinfield {

/// What both sides changed, for people: "pop: kick", and what it is before, here and there, as the texts say it.
struct ToldConflict {
    MergeConflict conflict;
    std::string what, base, mine, theirs;
};

struct MergedText {
    Reading reading;                        ///< sound where `refusal` is empty; its nodes have the ids they have in `mine`, and new ones
    std::vector<ToldConflict> conflicts{};  ///< told whether they are chosen or not
    std::string refusal{};                  ///< why there is no such text: the changes do not go together, or no text is known for them
    int comments_left_out = 0;              ///< that one side has put in, and the merged text has not
};

/// The text of `theirs` with what differs between `base` and `mine`: line by line where that says what merge() wants, the rest as patches;
/// so it has been read, and says that. Nodes of `base` and `mine` are the same where they have the same id. Where one side has changed
/// nothing it is the other's, byte for byte. All three must be ok().
MergedText merge_text(const Reading& base, const Reading& mine, Reading theirs, const Choices& choices = {});

}  // namespace pinfield
