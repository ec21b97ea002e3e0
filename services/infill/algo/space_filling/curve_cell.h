#pragma once

#include <compare>
#include <cstdint>

namespace slicefarm::infill {

/// A cell of a square that a space-filling curve runs through.
struct CurveCell {
  uint32_t x = 0;
  uint32_t y = 0;

  friend auto operator<=>(const CurveCell&, const CurveCell&) = default;
};

}  // namespace slicefarm::infill
