// Lowering: a CSG tree of line-and-arc shapes becomes its own boundary, whose distance is exact on both sides.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// Appends the boundary pieces of a solid to field.pieces and marks it as lowered, when its tree is made of shapes with
/// outlines under union, intersection, difference, xor, complement, images, and offsets of such; else leaves the field as it is.
/// The solid must be the last one with pieces.
void lower(Field& field, int solid);

}  // namespace pinfield
