#include "common/geometry/predicates.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>

namespace slicefarm {
namespace {

/// Limit of coordinates (about 1 m) up to which products of differences fit into 63 bits.
constexpr Coord kSmall = Coord{1} << 30;

bool AreSmall(Point a, Point b, Point c) {
  const auto lifted = [](Coord v) { return static_cast<uint64_t>(v) + uint64_t{kSmall}; };
  return (lifted(a.x) | lifted(a.y) | lifted(b.x) | lifted(b.y) | lifted(c.x) | lifted(c.y)) <
         uint64_t{2 * kSmall};
}

/// Limit of coordinates up to which differences fit into 63 bits and differences of two products
/// into 127 bits.
constexpr Coord kNarrow = Coord{1} << 61;

bool IsNarrow(Point p) {
  return p.x >= -kNarrow && p.x <= kNarrow && p.y >= -kNarrow && p.y <= kNarrow;
}

template <typename Int>
int OrientationIn(Point a, Point b, Point c) {
  const Int abx = Int(b.x) - Int(a.x), aby = Int(b.y) - Int(a.y);
  const Int acx = Int(c.x) - Int(a.x), acy = Int(c.y) - Int(a.y);
  const Int left = abx * acy, right = aby * acx;
  return left > right ? 1 : left < right ? -1 : 0;
}

}  // namespace

int Orientation(Point a, Point b, Point c) {
  if (AreSmall(a, b, c)) return OrientationIn<Coord>(a, b, c);
  if (IsNarrow(a) && IsNarrow(b) && IsNarrow(c)) return OrientationIn<__int128>(a, b, c);
  return OrientationIn<boost::multiprecision::int256_t>(a, b, c);
}

bool OnSegment(Point p, Point a, Point b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y) && Orientation(a, b, p) == 0;
}

}  // namespace slicefarm
