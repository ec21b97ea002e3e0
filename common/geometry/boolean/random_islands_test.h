#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

// Random regions for tests, and simple measures of them that share no code with the offsets.

/// Returns a number in [from, to), made only from the generator's bits, so that it is the same with
/// every standard library.
inline double Uniform(std::mt19937& random, double from, double to) {
  return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
}

/// Returns a ring around the origin with 3 to 30 corners. Their radii are between `depth` times the
/// radius and the radius.
inline Polygon RandomStar(std::mt19937& random, double radius_mm, double depth) {
  Polygon ring;
  const int corners = 3 + static_cast<int>(Uniform(random, 0, 28));
  const double turn = Uniform(random, 0, 6);
  for (int i = 0; i < corners; ++i) {
    const double t = turn + 2 * std::numbers::pi * (i + Uniform(random, 0, 0.8)) / corners;
    const double r = radius_mm * Uniform(random, depth, 1);
    ring.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
  }
  return ring;
}

/// Returns an island around `middle`. Half of these islands have a hole, and some of the holes
/// contain an island.
inline MultiPolygon RandomIsland(std::mt19937& random, Point middle, double radius_mm) {
  const double depth = Uniform(random, 0.25, 1);
  std::vector<Polygon> rings = {RandomStar(random, radius_mm, depth)};
  MultiPolygon island = Union(rings, FillRule::kNonZero);
  if (random() % 2 == 0) {
    const double hole_mm = radius_mm * Uniform(random, 0.2, 0.8);
    rings = {RandomStar(random, hole_mm, 0.4)};
    island = Difference(island, Union(rings, FillRule::kNonZero));
    if (random() % 3 == 0) {
      rings = {RandomStar(random, hole_mm * 0.5, 0.4)};
      island = Union(island, Union(rings, FillRule::kNonZero));
    }
  }
  return Moved(island, middle);
}

inline bool Inside(Point p, const MultiPolygon& region) {
  return std::any_of(region.begin(), region.end(), [p](const PolygonWithHoles& island) {
    return Locate(p, island) != Side::kOutside;
  });
}

/// Returns the distance from p to the nearest point of any ring; infinite if there is none.
inline double DistanceToBoundary(Point p, const MultiPolygon& region) {
  double nearest = INFINITY;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      nearest = std::min(nearest, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  });
  return nearest;
}

inline double DistanceToRegion(Point p, const MultiPolygon& region) {
  return Inside(p, region) ? 0 : DistanceToBoundary(p, region);
}

inline Point RandomPoint(std::mt19937& random, const Box& box) {
  return {
      std::llround(Uniform(random, static_cast<double>(box.min.x), static_cast<double>(box.max.x))),
      std::llround(
          Uniform(random, static_cast<double>(box.min.y), static_cast<double>(box.max.y)))};
}

/// Calls visit(p) for points on all rings: corners, and points every `step_nm` between them.
template <typename Visit>
void ForEachBoundaryPoint(const MultiPolygon& region, double step_nm, Visit visit) {
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      const int pieces = 1 + static_cast<int>(Distance(a, b) / step_nm);
      for (int k = 0; k < pieces; ++k)
        visit(Point{a.x + (b.x - a.x) * k / pieces, a.y + (b.y - a.y) * k / pieces});
    }
  });
}

/// Returns the region turned by 90 degrees and mirrored in the y axis.
inline MultiPolygon QuarterTurned(MultiPolygon region) {
  for (PolygonWithHoles& island : region) {
    for (Point& p : island.outer) p = {-p.y, p.x};
    for (Polygon& hole : island.holes)
      for (Point& p : hole) p = {-p.y, p.x};
  }
  Canonicalize(region);
  return region;
}

inline MultiPolygon Mirrored(MultiPolygon region) {
  const auto mirror = [](Polygon& ring) {
    for (Point& p : ring) p.x = -p.x;
    std::reverse(ring.begin(), ring.end());
  };
  for (PolygonWithHoles& island : region) {
    mirror(island.outer);
    for (Polygon& hole : island.holes) mirror(hole);
  }
  Canonicalize(region);
  return region;
}

}  // namespace slicefarm
