#include "services/beading/algo/wall_rings.h"

#include <algorithm>
#include <cstdint>

#include "common/geometry/measure.h"

namespace slicefarm::beading {
namespace {

struct Ring {
  const Polygon* points;
  Box box;
};

std::vector<Ring> RingsOf(const MultiPolygon& outline) {
  std::vector<Ring> rings;
  ForEachRing(outline, [&](const Polygon& ring) { rings.push_back({&ring, Bounds(ring)}); });
  return rings;
}

double DistanceToRing(Point p, const Polygon& ring) {
  double nearest = DistanceToSegment(p, ring.back(), ring.front());
  for (size_t i = 1; i < ring.size(); ++i)
    nearest = std::min(nearest, DistanceToSegment(p, ring[i - 1], ring[i]));
  return nearest;
}

double DistanceToBox(Point p, const Box& box) {
  return Distance(p,
                  {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)});
}

int32_t RingAt(Point p, double reach_nm, const std::vector<Ring>& rings) {
  int32_t best = -1;
  double nearest = reach_nm;
  for (size_t i = 0; i < rings.size(); ++i) {
    if (DistanceToBox(p, rings[i].box) >= nearest) continue;
    const double distance = DistanceToRing(p, *rings[i].points);
    if (distance >= nearest) continue;
    nearest = distance;
    best = static_cast<int32_t>(i);
  }
  return best;
}

}  // namespace

void NameRings(const MultiPolygon& outline, std::vector<Path>& walls) {
  const std::vector<Ring> rings = RingsOf(outline);
  for (Path& wall : walls) {
    const bool outermost = wall.closed && wall.inset == 0 && wall.feature != Feature::kGapFill;
    if (!outermost) continue;
    wall.ring =
        rings.size() == 1 ? 0 : RingAt(wall.points[0], static_cast<double>(wall.WidthAt(0)), rings);
  }
}

}  // namespace slicefarm::beading
