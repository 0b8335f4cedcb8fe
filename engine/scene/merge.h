// Two tables that were made of one, made one again.
#pragma once
#include <compare>
#include <map>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace pinfield {

enum class Whose : unsigned char { mine, theirs };

/// What both sides changed, each otherwise; or what one took out and the other changed.
struct MergeConflict {
    enum class About : unsigned char { value, type, place, presence, input, test };
    About about = About::value;
    NodeId node{};      ///< none: an input or a test
    std::string key{};  ///< of a value its field ("name": a material's name); of an input or a test its name

    auto operator<=>(const MergeConflict&) const = default;
};

/// Whose version is taken; of what is not in it, theirs.
using Choices = std::map<MergeConflict, Whose>;

struct MergedScene {
    Scene scene;  ///< its nodes stand nowhere in a text; it may be unsound where the sides' changes do not go together: validate()
    std::vector<MergeConflict> conflicts{};  ///< the same ones whatever is chosen, but for those that a choice brings about
};

/// `theirs` with all that differs between `base` and `mine`. A node is the same in all three where it has the same id: match(). Values,
/// types, places and orders are merged each for itself; what both sides say alike is no conflict. New names are followed by what the other
/// side says.
MergedScene merge(const Scene& base, const Scene& mine, const Scene& theirs, const Choices& choices = {});

/// Gives the nodes of `theirs` the ids that merge() goes by: of what `base` holds, else of what `mine` has put in alike.
void share_ids(const Scene& base, const Scene& mine, Scene& theirs);

}  // namespace pinfield
