#include "services/exposure/algo/decompose/cgal_partition.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

#include <cmath>
#include <iterator>
#include <list>

#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/ring_cleaning.h"
#include "common/geometry/rings/simple_rings.h"

namespace slicefarm::exposure {
namespace {

using Traits = CGAL::Partition_traits_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
using CgalPolygon = Traits::Polygon_2;

/// largest relative error of the pieces' total area, because areas are rounded to doubles
constexpr double kAreaTolerance = 1e-12;

bool IsConvex(const Polygon& ring) {
  for (size_t i = 0, n = ring.size(); i < n; ++i)
    if (Orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
  return ring.size() >= 3;
}

bool AreRight(const std::vector<Polygon>& pieces, const Polygon& whole) {
  double area = 0;
  for (const Polygon& piece : pieces) {
    if (!IsConvex(piece)) return false;
    area += SignedArea(piece);
  }
  const double expected = SignedArea(whole);
  return std::abs(area - expected) <= kAreaTolerance * expected;
}

/// Divides a polygon into y-monotone parts, and returns the convex pieces of these parts. A
/// y-monotone part meets each horizontal line in one segment at most but need not be convex, so
/// each part is cut again.
std::list<CgalPolygon> ConvexPartsOfMonotoneOnes(const CgalPolygon& whole) {
  const Traits traits;
  std::list<CgalPolygon> monotone, parts;
  CGAL::y_monotone_partition_2(whole.vertices_begin(), whole.vertices_end(),
                               std::back_inserter(monotone), traits);
  for (const CgalPolygon& part : monotone) {
    CGAL::approx_convex_partition_2(part.vertices_begin(), part.vertices_end(),
                                    std::back_inserter(parts), traits);
  }
  return parts;
}

}  // namespace

std::optional<std::vector<Polygon>> CgalPartition(const Polygon& polygon, DecomposeMethod method) {
  const bool optimal = method == DecomposeMethod::kOptimal;
  const Polygon* const ring = &polygon;
  if ((optimal && polygon.size() > kMaxOptimalCorners) || !AreSimple({&ring, 1}))
    return std::nullopt;
  CgalPolygon whole;
  for (const Point p : polygon)
    whole.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  std::list<CgalPolygon> parts;
  const Traits traits;
  if (optimal) {
    CGAL::optimal_convex_partition_2(whole.vertices_begin(), whole.vertices_end(),
                                     std::back_inserter(parts), traits);
  } else if (method == DecomposeMethod::kYMonotone) {
    parts = ConvexPartsOfMonotoneOnes(whole);
  } else {
    CGAL::approx_convex_partition_2(whole.vertices_begin(), whole.vertices_end(),
                                    std::back_inserter(parts), traits);
  }
  std::vector<Polygon> pieces;
  for (const CgalPolygon& part : parts) {
    Polygon piece;
    for (const auto& p : part.container())
      piece.push_back({static_cast<Coord>(p.x()), static_cast<Coord>(p.y())});
    pieces.push_back(CleanedRing(piece));
  }
  if (!AreRight(pieces, polygon)) return std::nullopt;
  return pieces;
}

}  // namespace slicefarm::exposure
