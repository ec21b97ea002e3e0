#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Rows of waves, each row opposite to its neighbours, so that they close cells where they meet.
/// Over the height, the waves grow from flat to the point where neighbours are side by side, and
/// shrink again, at 45 degrees. Then the rows turn by a right angle. Rows are P apart, waves are 4
/// P long with slopes of 45 degrees, and a period in z is 4 times their greatest height.
///
/// Density: a wave of height +-a is 1 + (sqrt 2 - 1) a / P times as long as a line. The mean of a
/// is half of its maximum, (P - spacing) / 4. Therefore P = pitch (1 + (sqrt 2 - 1) (1 - spacing /
/// P) / 4).
MakePattern Honeycomb3d;

}  // namespace slicefarm::infill
