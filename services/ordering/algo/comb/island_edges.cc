#include "services/ordering/algo/comb/island_edges.h"

#include <cmath>
#include <iterator>
#include <numeric>

namespace slicefarm::ordering {

bool IsOuterWall(const Path& path) {
  return path.inset == 0 && (path.feature == Feature::kExternalPerimeter ||
                             path.feature == Feature::kOverhangPerimeter);
}

Coord OuterWallRadius(std::span<const Path> paths) {
  Coord sum = 0, count = 0;
  for (const Path& path : paths) {
    if (!IsOuterWall(path) || !path.closed) continue;
    sum = std::accumulate(path.widths_nm.begin(), path.widths_nm.end(), sum);
    count += std::ssize(path.widths_nm);
  }
  return count == 0 ? 0 : sum / (2 * count);
}

namespace {

/// At its ends a travel comes from a wall and goes to one.
constexpr double kEndsNm = 300'000;

Point At(Point from, double dx, double dy) {
  return {from.x + std::llround(dx), from.y + std::llround(dy)};
}

}  // namespace

bool IslandEdges::Grazes(Point a, Point b, Coord near_nm) const {
  const double length = Distance(a, b);
  if (length <= 2 * kEndsNm) return false;
  const double x = static_cast<double>(b.x - a.x) / length;
  const double y = static_cast<double>(b.y - a.y) / length;
  const auto near = static_cast<double>(near_nm);
  for (const double aside : {near, -near}) {
    const Point from = At(a, kEndsNm * x - aside * y, kEndsNm * y + aside * x);
    const Point to = At(b, -kEndsNm * x - aside * y, -kEndsNm * y + aside * x);
    if (walls_.Crosses(from, to)) return true;
  }
  return false;
}

IslandEdges::IslandEdges(const FilledIsland& island) {
  outline_.AddRing(island.outline.outer);
  for (const Polygon& hole : island.outline.holes) outline_.AddRing(hole);
  for (const Path& wall : island.walls) {
    if (!IsOuterWall(wall)) continue;
    wall.closed ? walls_.AddRing(wall.points) : walls_.AddLine(wall.points);
  }
  outline_.Build();
  walls_.Build();
}

}  // namespace slicefarm::ordering
