#include "services/exposure/algo/decompose/merge_corners.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/rings/ring_cleaning.h"
#include "services/exposure/algo/decompose/cut_region.h"
#include "services/exposure/algo/decompose/exact_vector.h"

namespace slicefarm::exposure {
namespace {

/// Returns true if p is in the closed triangle and is not one of its corners.
bool InTriangle(Point p, Point a, Point b, Point c) {
  if (p == a || p == b || p == c) return false;
  const int ab = CrossSign(ToVector(b - a), ToVector(p - a));
  const int bc = CrossSign(ToVector(c - b), ToVector(p - b));
  const int ca = CrossSign(ToVector(a - c), ToVector(p - c));
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

class Merger {
 public:
  Merger(const MultiPolygon& islands, const MergeLimits& limits)
      : islands_(islands), limits_(limits) {}

  Polygon Merge(const Polygon& given) {
    Polygon ring = CleanedRing(given);
    for (size_t i = 0; i < ring.size() && ring.size() > 3;) {
      if (GoesWith(Before(ring, i), ring[i], After(ring, i)))
        ring.erase(ring.begin() + static_cast<ptrdiff_t>(i));
      else
        ++i;
    }
    return CleanedRing(ring);
  }

 private:
  bool GoesWith(Point a, Point p, Point b) {
    const Vector2 chord = ToVector(b - a), to_p = ToVector(p - a);
    const double along = Dot(chord, to_p), length = Norm(chord);
    const double twice_area = std::abs(chord.x() * to_p.y() - chord.y() * to_p.x());
    if (!(along > 0 && along < length * length) || twice_area > limits_.sagitta * length ||
        area_ + 0.5 * twice_area > limits_.area)
      return false;
    bool empty = true;
    ForEachRing(islands_, [&](const Polygon& ring) {
      for (const Point q : ring) empty = empty && !InTriangle(q, a, p, b);
    });
    if (empty) area_ += 0.5 * twice_area;
    return empty;
  }

  const MultiPolygon& islands_;
  const MergeLimits& limits_;
  double area_ = 0;  ///< sum of the removed and added areas so far
};

}  // namespace

MultiPolygon MergeCorners(const MultiPolygon& islands, const MergeLimits& limits) {
  MultiPolygon merged;
  Merger merger(islands, limits);
  for (const PolygonWithHoles& island : islands) {
    PolygonWithHoles result{.outer = merger.Merge(island.outer), .holes = {}};
    if (result.outer.empty()) continue;
    for (const Polygon& hole : island.holes)
      if (Polygon ring = merger.Merge(hole); !ring.empty()) result.holes.push_back(std::move(ring));
    merged.push_back(std::move(result));
  }
  return merged;
}

}  // namespace slicefarm::exposure
