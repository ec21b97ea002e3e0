#pragma once

#include <cmath>
#include <cstdint>

#include "common/geometry/point.h"
#include "common/geometry/vector.h"

namespace slicefarm::exposure {

/// Largest absolute coordinate of polygons for decomposition. Within this limit, doubles store the
/// difference of two edge vectors exactly.
inline constexpr Coord kExactCoord = Coord{1} << 51;

/// Returns +1 if b is to the left of a, -1 if it is to the right, 0 if both are on one line. Exact
/// like Orientation; faster if many vectors start at the same point.
inline int CrossSign(Vector2 a, Vector2 b) {
  const double left = a.x() * b.y();
  const double right = a.y() * b.x();
  const double cross = left - right;
  // The bound covers three roundings of at most 2^-53 each.
  if (std::abs(cross) > 4.5e-16 * (std::abs(left) + std::abs(right))) return cross > 0 ? 1 : -1;
  const __int128 exact =
      static_cast<__int128>(static_cast<int64_t>(a.x())) * static_cast<int64_t>(b.y()) -
      static_cast<__int128>(static_cast<int64_t>(a.y())) * static_cast<int64_t>(b.x());
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

/// Returns the cosine of the angle between two vectors. REQUIRES: neither is zero.
inline double CosineOf(Vector2 a, Vector2 b) { return Dot(a, b) / (Norm(a) * Norm(b)); }

}  // namespace slicefarm::exposure
