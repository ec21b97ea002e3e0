#pragma once

#include <cmath>
#include <initializer_list>

namespace slicefarm {

/// Returns true if the value is a valid amount, such as a sum of lengths or times: finite and not
/// negative.
inline bool IsAmount(double value) { return std::isfinite(value) && value >= 0; }

/// Returns true if all values are amounts.
inline bool AreAmounts(std::initializer_list<double> values) {
  for (const double value : values)
    if (!IsAmount(value)) return false;
  return true;
}

}  // namespace slicefarm
