#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Parallel lines that keep one direction over some layers and then turn by a right angle. Layers
/// between two directions join the lines of both (OrcaSlicer's cross hatch).
///
/// Lines are a distance P apart. A period in z is a band of straight lines, P high, and a
/// transition, 0.4 P high. Below a density of 0.3, the band is only 1 - exp(-5 density) of P high,
/// at least 0.2 P, so that sparse lines are joined more often. In the transition, each line is a
/// wave with the period 2 P, mirrored to its neighbours. The amplitude of the waves grows from 0.05
/// P to 0.3 P. Then the direction turns, and the amplitude shrinks again. At 0.25 P the waves of
/// both directions have the same diagonals, so the turned lines are supported by the lines below.
/// The amplitude is limited so that neighbouring waves stay a spacing apart.
///
/// Density: exact over a period. P is the pitch times the ratio of a row's mean length to a
/// straight line's length: 1.04 to 1.1 at common densities.
MakePattern Crosshatch;

}  // namespace slicefarm::infill
