#include "common/geometry/offset/paths_within.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/covers.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm {
namespace {

constexpr Coord kHairNm = 1'000;
constexpr double kClearanceNm = 500'000;
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Returns true if ab crosses the edge cd, or passes through one of the edge's ends.
bool Crosses(Point a, Point b, Point c, Point d) {
  const double to_c = Cross(b - a, c - a), to_d = Cross(b - a, d - a);
  const double to_a = Cross(d - c, a - c), to_b = Cross(d - c, b - c);
  return to_c * to_d <= 0 && to_a * to_b < 0;
}

/// Returns the point of the region at the clearance from `corner`, along the bisector of its angle.
Point Off(Point before, Point corner, Point after) {
  const Point in = corner - before, out = after - corner;
  const double in_length = Norm(in), out_length = Norm(out);
  const double x = in.x / in_length - out.x / out_length;
  const double y = in.y / in_length - out.y / out_length;
  const double length = std::sqrt(x * x + y * y);
  if (length == 0) return corner;
  return {corner.x + std::llround(kClearanceNm * x / length),
          corner.y + std::llround(kClearanceNm * y / length)};
}

/// Adds the corners of a ring that point into the region. The region is to the left of the ring.
void AddBends(const Polygon& ring, std::vector<Point>& bends) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point before = ring[(i + ring.size() - 1) % ring.size()];
    const Point after = ring[(i + 1) % ring.size()];
    if (Cross(ring[i] - before, after - ring[i]) < 0) bends.push_back(Off(before, ring[i], after));
  }
}

}  // namespace

PathsWithin::PathsWithin(const MultiPolygon& region) {
  if (region.empty()) return;
  region_ = Offset(region, kHairNm);
  ForEachRing(region, [this](const Polygon& ring) { AddBends(ring, bends_); });
  std::erase_if(bends_, [this](Point bend) { return !Covers(region_, bend); });
  lengths_.assign(bends_.size(), std::vector<double>(bends_.size(), kFar));
  for (size_t i = 0; i < bends_.size(); ++i)
    for (size_t k = 0; k < i; ++k)
      if (Sees(bends_[i], bends_[k]))
        lengths_[i][k] = lengths_[k][i] = Distance(bends_[i], bends_[k]);
}

bool PathsWithin::Sees(Point a, Point b) const {
  bool sees = true;
  ForEachRing(region_, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size() && sees; ++i)
      sees = !Crosses(a, b, ring[i], ring[(i + 1) % ring.size()]);
  });
  return sees;
}

/// Algorithm: Dijkstra's algorithm over the bends.
PathsWithin::Tree PathsWithin::PathsFrom(Point a) const {
  const size_t count = bends_.size();
  Tree tree{std::vector<double>(count, kFar), std::vector<size_t>(count, count)};
  for (size_t i = 0; i < count; ++i)
    if (Sees(a, bends_[i])) tree.length[i] = Distance(a, bends_[i]);
  std::vector<bool> done(count, false);
  for (;;) {
    size_t next = count;
    for (size_t i = 0; i < count; ++i)
      if (!done[i] && tree.length[i] < (next == count ? kFar : tree.length[next])) next = i;
    if (next == count) return tree;
    done[next] = true;
    for (size_t i = 0; i < count; ++i) {
      const double length = tree.length[next] + lengths_[next][i];
      if (length >= tree.length[i]) continue;
      tree.length[i] = length;
      tree.before[i] = next;
    }
  }
}

std::vector<Point> PathsWithin::Between(Point a, Point b) const {
  if (bends_.empty() || Sees(a, b) || !Covers(region_, a) || !Covers(region_, b)) return {};
  const Tree tree = PathsFrom(a);
  size_t last = bends_.size();
  double best = kFar;
  for (size_t i = 0; i < bends_.size(); ++i) {
    const double length = tree.length[i] + Distance(bends_[i], b);
    if (length >= best || !Sees(bends_[i], b)) continue;
    best = length;
    last = i;
  }
  std::vector<Point> corners;
  for (; last != bends_.size(); last = tree.before[last]) corners.push_back(bends_[last]);
  std::ranges::reverse(corners);
  return corners;
}

}  // namespace slicefarm
