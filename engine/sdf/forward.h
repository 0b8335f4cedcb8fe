// Names of the shapes that parts have by custom. A part's header is read all over the engine: with the name alone it does not
// drag the shape's formula along, so that touching a formula rebuilds the catalog and little else.
#pragma once

namespace pinfield::sdf {

template <class Real>
struct Box;
template <class Real>
struct Circle;
template <class Real>
struct UnevenCapsule;

}  // namespace pinfield::sdf
