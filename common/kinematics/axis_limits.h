#pragma once

#include <array>

namespace slicefarm {

/// Returns `value`, lowered until no axis exceeds its limit. `value`: speed or acceleration of a
/// move. `ratio`: share of each axis in it. `limits`: limit per axis; limits of 0 are ignored.
double LimitedByAxes(double value, const std::array<double, 4>& ratio,
                     const std::array<double, 4>& limits);

}  // namespace slicefarm
