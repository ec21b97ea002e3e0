#include "services/infill/algo/axis/axis_spokes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "common/geometry/measure.h"

namespace slicefarm::infill {
namespace {

/// Distance in nm within which an axis reaches a ring: twice the precision of MainAxis.
constexpr double kReachedNm = 40'000;

/// Calls visit(a, b) for the edges of a ring.
template <typename Visit>
void ForEachEdgeOf(const Polygon& ring, Visit visit) {
  for (size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
}

bool Reaches(const std::vector<Polyline>& axis, const Polygon& ring) {
  bool reached = false;
  ForEachEdgeOf(ring, [&](Point a, Point b) {
    for (const Polyline& line : axis)
      for (const Point end : {line.front(), line.back()})
        reached = reached || DistanceToSegment(end, a, b) <= kReachedNm;
  });
  return reached;
}

/// Returns the shortest line from a point of the ring to a point of the axis, or nothing if this
/// line has no length.
std::optional<Polyline> SpokeTo(const std::vector<Polyline>& axis, const Polygon& ring) {
  double shortest = std::numeric_limits<double>::infinity();
  Polyline spoke;
  for (const Point at : ring) {
    for (const Polyline& line : axis) {
      for (const Point point : line) {
        const double length = SquaredNorm(point - at);
        if (length >= shortest) continue;
        shortest = length;
        spoke = {at, point};
      }
    }
  }
  if (spoke.empty() || spoke[0] == spoke[1]) return std::nullopt;
  return spoke;
}

}  // namespace

std::vector<Polyline> AxisSpokes(const PolygonWithHoles& island,
                                 const std::vector<Polyline>& axis) {
  std::vector<Polyline> spokes;
  ForEachRing({island}, [&](const Polygon& ring) {
    if (Reaches(axis, ring)) return;
    if (auto spoke = SpokeTo(axis, ring)) spokes.push_back(*std::move(spoke));
  });
  return spokes;
}

}  // namespace slicefarm::infill
