#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Rows of waves, each row mirrored to its neighbours, so that cells close where neighbours meet.
/// With the height, the amplitude of the waves grows from 0 until neighbours are side by side, and
/// shrinks again, at 45 degrees. Then the rows turn by a right angle. Rows are P apart, and waves
/// have the period 4 P with slopes of 45 degrees. A period in z is 4 times their largest amplitude.
///
/// Density: a wave of amplitude a is 1 + (sqrt 2 - 1) a / P times as long as a straight line. The
/// mean of a is half of its maximum, (P - spacing) / 4. Therefore P = pitch (1 + (sqrt 2 - 1) (1 -
/// spacing / P) / 4).
MakePattern Honeycomb3d;

}  // namespace slicefarm::infill
