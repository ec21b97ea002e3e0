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

std::vector<Point> PointsOf(Point from, std::span<const Point> corners, Point to) {
  std::vector<Point> places = {from};
  places.insert(places.end(), corners.begin(), corners.end());
  places.push_back(to);
  return places;
}

namespace {

/// Length in nm at either end of a travel that is not tested, because a travel may start or end at
/// a wall.
constexpr double kEndsNm = 300'000;
/// The same length for crossings of the centre line itself; larger than any rounding.
constexpr double kRoundedEndsNm = 1'000;

Point At(Point from, double dx, double dy) {
  return {from.x + std::llround(dx), from.y + std::llround(dy)};
}

}  // namespace

bool IslandEdges::Parts(Point a, Point b) const {
  if (outline_.Meets(a, b)) return true;
  if (!walls_.Crosses(a, b)) return false;
  const double length = Distance(a, b);
  if (length <= 2 * kRoundedEndsNm) return false;
  const double x = kRoundedEndsNm * static_cast<double>(b.x - a.x) / length;
  const double y = kRoundedEndsNm * static_cast<double>(b.y - a.y) / length;
  return walls_.Crosses(At(a, x, y), At(b, -x, -y));
}

bool IslandEdges::Grazes(std::span<const Point> route, Coord near_nm) const {
  const auto near = static_cast<double>(near_nm);
  for (size_t i = 1; i < route.size(); ++i) {
    const Point a = route[i - 1], b = route[i];
    const double length = Distance(a, b);
    const double start = i == 1 ? kEndsNm : 0, end = i + 1 == route.size() ? kEndsNm : 0;
    if (length <= start + end) continue;
    const double x = static_cast<double>(b.x - a.x) / length;
    const double y = static_cast<double>(b.y - a.y) / length;
    for (const double aside : {near, -near}) {
      const Point from = At(a, start * x - aside * y, start * y + aside * x);
      const Point to = At(b, -end * x - aside * y, -end * y + aside * x);
      if (walls_.Crosses(from, to)) return true;
    }
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
