#pragma once

#include <array>

namespace slicefarm {

/// Returns `value`, reduced until no axis exceeds its limit. `value`: speed or acceleration along a
/// move. `ratio`: movement of each axis per mm of the move. `limits`: limit per axis; a limit of 0
/// is ignored.
double LimitedByAxes(double value, const std::array<double, 4>& ratio,
                     const std::array<double, 4>& limits);

}  // namespace slicefarm
