#pragma once

#include <compare>
#include <cstdint>

namespace slicefarm::infill {

/// Cell of a square grid, on a space-filling curve.
struct CurveCell {
  uint32_t x = 0;
  uint32_t y = 0;

  friend auto operator<=>(const CurveCell&, const CurveCell&) = default;
};

}  // namespace slicefarm::infill
