#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Parallel lines, a pitch apart. Rectilinear lines turn by a right angle from layer to layer;
/// aligned ones do not. The length per area is exactly 1 / pitch.
MakePattern Rectilinear;
MakePattern AlignedRectilinear;
/// Aligned lines, mirrored if the options say so.
MakePattern Zigzag;
/// Zigzag lines that shift from layer to layer, in even and in odd layers to opposite sides.
MakePattern CrossZag;

}  // namespace slicefarm::infill
