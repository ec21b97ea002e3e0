#pragma once

#include <array>

namespace slicefarm {

/// `value` in the direction `ratio`, lowered until no axis exceeds its part of `limits`. Limits of
/// 0 do not count.
double LimitedByAxes(double value, const std::array<double, 4>& ratio,
                     const std::array<double, 4>& limits);

}  // namespace slicefarm
