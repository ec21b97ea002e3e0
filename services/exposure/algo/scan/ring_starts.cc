#include "services/exposure/algo/scan/ring_starts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/geometry/measure.h"

namespace slicefarm::exposure {
namespace {

/// Point of a closed line: index of the point at which its edge starts, and its position.
struct RingPoint {
  size_t edge = 0;
  Point at;
};

/// Calls visit(edge, a, b) for the edges of a closed line that belong to no spur.
template <typename Visit>
void ForEachSide(const Polyline& ring, Visit visit) {
  const size_t size = ring.size() - 1;
  const auto is_tip = [&](size_t i) { return ring[(i + size - 1) % size] == ring[(i + 1) % size]; };
  for (size_t i = 0; i < size; ++i)
    if (!is_tip(i) && !is_tip((i + 1) % size)) visit(i, ring[i], ring[i + 1]);
}

RingPoint PointAtShare(const Polyline& ring, double share) {
  double length = 0;
  ForEachSide(ring, [&](size_t, Point a, Point b) { length += Distance(a, b); });
  RingPoint point{0, ring[0]};
  double left = share * length;
  ForEachSide(ring, [&](size_t edge, Point a, Point b) {
    const double side = Distance(a, b);
    if (left >= 0 && left <= side && side > 0) {
      const double t = left / side;
      point = {edge, a + Point{std::llround(t * static_cast<double>(b.x - a.x)),
                               std::llround(t * static_cast<double>(b.y - a.y))}};
    }
    left -= side;
  });
  return point;
}

RingPoint NearestRingPoint(const Polyline& ring, Point p) {
  RingPoint point{0, ring[0]};
  double nearest = std::numeric_limits<double>::infinity();
  ForEachSide(ring, [&](size_t edge, Point a, Point b) {
    const Point at = NearestOnSegment(p, a, b);
    const double distance = Distance(p, at);
    if (distance >= nearest) return;
    nearest = distance;
    point = {edge, at};
  });
  return point;
}

/// Returns the point where the line from `in`, inside of the ring, to `out` leaves the ring. If
/// rounding hides this point, returns the point nearest to `out`.
RingPoint CrossingPoint(const Polyline& ring, Point in, Point out) {
  std::optional<RingPoint> point;
  ForEachSide(ring, [&](size_t edge, Point a, Point b) {
    const double from = Cross(out - in, a - in), to = Cross(out - in, b - in);
    if (from > 0 || to <= 0) return;  // a convex ring is left from right to left
    const double t = from / (from - to);
    point = {edge, a + Point{std::llround(t * static_cast<double>(b.x - a.x)),
                             std::llround(t * static_cast<double>(b.y - a.y))}};
  });
  return point ? *point : NearestRingPoint(ring, out);
}

void StartAt(const RingPoint& point, Polyline& ring) {
  ring.pop_back();
  size_t first = point.edge;
  if (point.at != ring[first]) {
    first = (first + 1) % ring.size();
    if (point.at != ring[first]) {
      first = point.edge + 1;
      ring.insert(ring.begin() + static_cast<ptrdiff_t>(first), point.at);
    }
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<ptrdiff_t>(first), ring.end());
  ring.push_back(ring.front());
}

bool IsClosed(const Polyline& line) { return line.size() > 3; }

}  // namespace

void StartAtShare(std::vector<Polyline>& rings, double share) {
  if (rings.empty() || !IsClosed(rings.front())) return;
  const RingPoint outer = PointAtShare(rings.front(), share);
  const Polyline& innermost = rings.back();
  const Point inner = IsClosed(innermost)
                          ? NearestRingPoint(innermost, outer.at).at
                          : NearestOnSegment(outer.at, innermost.front(), innermost.back());
  StartAt(outer, rings.front());
  for (size_t i = 1; i < rings.size(); ++i) {
    if (!IsClosed(rings[i])) continue;
    StartAt(i + 1 == rings.size() ? NearestRingPoint(rings[i], outer.at)
                                  : CrossingPoint(rings[i], inner, outer.at),
            rings[i]);
  }
}

}  // namespace slicefarm::exposure
