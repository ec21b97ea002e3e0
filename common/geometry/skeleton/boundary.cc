#include "common/geometry/skeleton/boundary.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/ring_cleaning.h"
#include "common/geometry/rings/simple_rings.h"

namespace slicefarm {
namespace {

constexpr Coord kCoarseUnitNm = 1'000;

Coord OnGrid(Coord nm, Coord unit_nm) {
  return std::llround(static_cast<double>(nm) / static_cast<double>(unit_nm));
}

/// Adds a ring. Returns false for a ring without an interior.
bool AppendRing(Polygon ring, Boundary& boundary) {
  for (Point& p : ring) {
    p = p - boundary.origin;
    if (boundary.unit_nm != 1) p = {OnGrid(p.x, boundary.unit_nm), OnGrid(p.y, boundary.unit_nm)};
  }
  Polygon points = CleanedRing(ring);
  if (points.empty()) return false;
  const int first = static_cast<int>(boundary.edges.size());
  const int count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i) {
    const int next = i + 1 == count ? 0 : i + 1;
    boundary.edges.push_back(
        {points[i], points[next], first + (i == 0 ? count - 1 : i - 1), first + next});
  }
  boundary.rings.push_back(std::move(points));
  return true;
}

int TurnAtStart(const Boundary& boundary, int edge) {
  const BoundaryEdge& after = boundary.edges[edge];
  return Orientation(boundary.edges[after.previous].from, after.from, after.to);
}

}  // namespace

bool Boundary::StartsReflex(int edge) const { return TurnAtStart(*this, edge) < 0; }
bool Boundary::StartsConvex(int edge) const { return TurnAtStart(*this, edge) > 0; }

BoundaryFeature Boundary::Before(BoundaryFeature feature) const {
  if (!feature.is_corner && StartsReflex(feature.edge)) return {feature.edge, true};
  return {edges[feature.edge].previous, false};
}

std::vector<BoundaryEdge> Boundary::EdgesInNm() const {
  std::vector<BoundaryEdge> scaled = edges;
  for (BoundaryEdge& edge : scaled)
    for (Point* p : {&edge.from, &edge.to}) *p = {p->x * unit_nm, p->y * unit_nm};
  return scaled;
}

std::optional<Boundary> MakeBoundary(const PolygonWithHoles& region, Coord unit_nm) {
  const Box box = Bounds(region.outer);
  const Coord limit = INT32_MAX * unit_nm;
  if (box.Empty() || box.max.x - box.min.x > limit || box.max.y - box.min.y > limit)
    return std::nullopt;
  Boundary boundary;
  boundary.origin = {box.min.x + (box.max.x - box.min.x) / 2,
                     box.min.y + (box.max.y - box.min.y) / 2};
  boundary.unit_nm = unit_nm;
  if (!AppendRing(region.outer, boundary)) return std::nullopt;
  for (const Polygon& hole : region.holes) AppendRing(hole, boundary);
  std::vector<const Polygon*> rings;
  for (const Polygon& ring : boundary.rings) rings.push_back(&ring);
  if (!AreSimple(rings)) return std::nullopt;
  return boundary;
}

std::optional<Boundary> MakeBoundary(const PolygonWithHoles& region) {
  std::optional<Boundary> boundary = MakeBoundary(region, kCoarseUnitNm);
  return boundary ? std::move(boundary) : MakeBoundary(region, 1);
}

}  // namespace slicefarm
