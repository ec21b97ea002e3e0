#include "common/geometry/rings/simplify.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"

namespace slicefarm {
namespace {

/// Marks the points of line[first..last] that Douglas-Peucker keeps, ends excluded. It is
/// iterative, so that a spiral of 10^6 points does not exhaust the stack.
void MarkKept(const Polyline& line, size_t first, size_t last, double tolerance_nm,
              std::vector<bool>& keep) {
  std::vector<std::pair<size_t, size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double worst = tolerance_nm;
    size_t at = from;
    for (size_t i = from + 1; i < to; ++i) {
      const double distance = DistanceToSegment(line[i], line[from], line[to]);
      if (distance > worst) worst = distance, at = i;
    }
    if (at == from) continue;
    keep[at] = true;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

Polyline Kept(const Polyline& line, const std::vector<bool>& keep) {
  Polyline kept;
  for (size_t i = 0; i < line.size(); ++i)
    if (keep[i]) kept.push_back(line[i]);
  return kept;
}

}  // namespace

Polyline SimplifyLine(const Polyline& line, Coord tolerance_nm) {
  if (line.size() < 3) return line;
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  MarkKept(line, 0, line.size() - 1, static_cast<double>(tolerance_nm), keep);
  return Kept(line, keep);
}

Polygon SimplifyRing(const Polygon& ring, Coord tolerance_nm) {
  if (ring.size() < 3) return {};
  // The smallest point and the point farthest from it are corners of the convex hull, so both
  // belong to any good approximation.
  Polyline line = ring;
  std::rotate(line.begin(), std::min_element(line.begin(), line.end()), line.end());
  const Point start = line.front();
  size_t far = 0;
  for (size_t i = 1; i < line.size(); ++i) {
    const double gain = SquaredNorm(line[i] - start) - SquaredNorm(line[far] - start);
    if (gain > 0 || (gain == 0 && line[i] < line[far])) far = i;
  }
  if (far == 0) return {};
  line.push_back(start);
  std::vector<bool> keep(line.size(), false);
  keep[0] = keep[far] = true;
  MarkKept(line, 0, far, static_cast<double>(tolerance_nm), keep);
  MarkKept(line, far, line.size() - 1, static_cast<double>(tolerance_nm), keep);
  Polygon kept = Kept(line, keep);
  if (kept.size() < 3 || SignedArea(kept) == 0) return {};
  return kept;
}

MultiPolygon Simplify(const MultiPolygon& polygons, Coord tolerance_nm) {
  MultiPolygon simple;
  simple.reserve(polygons.size());
  for (const PolygonWithHoles& polygon : polygons) {
    PolygonWithHoles island{SimplifyRing(polygon.outer, tolerance_nm), {}};
    if (island.outer.empty()) continue;
    for (const Polygon& hole : polygon.holes) {
      Polygon ring = SimplifyRing(hole, tolerance_nm);
      if (!ring.empty()) island.holes.push_back(std::move(ring));
    }
    simple.push_back(std::move(island));
  }
  Canonicalize(simple);
  return simple;
}

}  // namespace slicefarm
