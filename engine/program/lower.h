// Lowering: a solid becomes its own boundary of lines and arcs, whose distance is right on both sides.
#pragma once
#include "engine/program/program.h"

namespace pinfield {

/// Appends the boundary pieces of a solid to field.pieces and marks it as lowered: exactly, where it is made of shapes with outlines under
/// union, intersection, difference, xor, complement, images, and offsets of such; as fitted to its zero line by trace.h where it is not.
/// Leaves the field as it is where the boundary has no end. The solid must be the last one with pieces. False when there is no solid at
/// all: what is cut from itself, or common to what is apart, which has a field and no inside.
bool lower(Field& field, int solid);

}  // namespace pinfield
