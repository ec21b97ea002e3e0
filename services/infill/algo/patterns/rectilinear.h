#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Parallel lines a pitch apart. They turn by a right angle from layer to layer; aligned ones do
/// not. Law: length per area 1 / pitch, exactly.
MakePattern Rectilinear;
MakePattern AlignedRectilinear;

}  // namespace slicefarm::infill
