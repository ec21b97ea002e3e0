#pragma once

#include <array>

namespace slicefarm {

/// Returns `value` in the direction `ratio`, lowered until no axis exceeds its limit in `limits`.
/// Limits of 0 are ignored.
double LimitedByAxes(double value, const std::array<double, 4>& ratio,
                     const std::array<double, 4>& limits);

}  // namespace slicefarm
