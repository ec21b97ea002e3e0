#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Parallel lines that keep one direction over some layers and then turn by a right angle, with
/// layers between that join both directions (OrcaSlicer's cross hatch).
///
/// Lines are P apart. A period in z is a band of straight lines and a transition of 0.4 P. The band
/// is P high. Below a density of 0.3, its height is 1 - exp(-5 density) of P, at least 0.2 P. So
/// sparse lines are joined more often. In the transition the lines are waves 2 P long, each
/// opposite to its neighbours. Their height +-a grows from 0.05 P to 0.3 P, the direction turns,
/// and the height shrinks again. At 0.25 P the waves of both directions have the same diagonals:
/// the turned lines rest on them. Waves of neighbours stay a spacing apart.
///
/// Density: exact over a period. P is the pitch times the ratio of a row's mean length to a
/// straight line's length: 1.04 to 1.1 at common densities.
MakePattern Crosshatch;

}  // namespace slicefarm::infill
