#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Rows of waves, each row against its neighbours, so that they close cells where they meet. The
/// waves' height grows from nothing to where neighbours lie side by side, and shrinks again, at 45
/// degrees; then the rows turn by a right angle. Rows lie P apart, waves are 4 P long with slopes
/// of 45 degrees, and a period in z is 4 times their greatest height.
///
/// Law: a wave of height +-a is 1 + (sqrt 2 - 1) a / P times as long as a line, and the mean of a
/// is half of its most, (P - spacing) / 4; so P = pitch (1 + (sqrt 2 - 1) (1 - spacing / P) / 4).
MakePattern Honeycomb3d;

}  // namespace slicefarm::infill
