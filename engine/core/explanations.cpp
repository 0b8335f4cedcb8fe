#include "engine/core/explanations.h"

#include <algorithm>

namespace pinfield {

const Explanation* explanation(Code code) {
    for (const auto family : {text_explanations(), structure_explanations(), reference_explanations(), doubt_explanations()}) {
        const auto found = std::find_if(family.begin(), family.end(), [&](const Explanation& e) { return e.code == code; });
        if (found != family.end()) return &*found;
    }
    return nullptr;
}

}  // namespace pinfield
