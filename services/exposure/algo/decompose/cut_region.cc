#include "services/exposure/algo/decompose/cut_region.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"
#include "services/exposure/algo/decompose/exact_vector.h"

namespace slicefarm::exposure {
namespace {

bool IsReflex(const Polygon& ring, size_t i) {
  return CrossSign(ToVector(ring[i] - Before(ring, i)), ToVector(After(ring, i) - ring[i])) < 0;
}

/// Removes point i if the ring does not bend at it.
void DropIfStraight(Polygon& ring, size_t i) {
  if (ring.size() > 3 &&
      CrossSign(ToVector(ring[i] - Before(ring, i)), ToVector(After(ring, i) - ring[i])) == 0)
    ring.erase(ring.begin() + static_cast<ptrdiff_t>(i));
}

/// Returns the ring's points from `first` to `last`, both included. If `last` is less than `first`,
/// the range continues at the ring's first point.
Polygon Chain(const Polygon& ring, size_t first, size_t last) {
  Polygon points;
  points.reserve(ring.size() + 2);
  if (last < first) {
    points.insert(points.end(), ring.begin() + static_cast<ptrdiff_t>(first), ring.end());
    first = 0;
  }
  points.insert(points.end(), ring.begin() + static_cast<ptrdiff_t>(first),
                ring.begin() + static_cast<ptrdiff_t>(last) + 1);
  return points;
}

/// Returns a range of the ring's points, closed by the cut from its last point to its first.
Polygon ClosedChain(const Polygon& ring, size_t first, size_t last) {
  Polygon points = Chain(ring, first, last);
  DropIfStraight(points, points.size() - 1);
  DropIfStraight(points, 0);
  return points;
}

/// Returns true if a ring is inside another ring. The rings may touch at corners.
bool LiesInside(const Polygon& ring, const Polygon& outer) {
  for (const Point p : ring) {
    const Side side = Locate(p, outer);
    if (side != Side::kBoundary) return side == Side::kInside;
  }
  return true;
}

/// Returns the ring that follows ring a from point i around to point i, crosses to point j of ring
/// b, follows ring b, and returns to point i.
Polygon Joined(const Polygon& a, size_t i, const Polygon& b, size_t j) {
  Polygon ring;
  ring.reserve(a.size() + b.size() + 2);
  const auto around = [&](const Polygon& of, size_t start) {
    for (size_t k = 0; k <= of.size(); ++k) ring.push_back(of[(start + k) % of.size()]);
  };
  around(a, i);
  around(b, j);
  // Removal from the last index to the first keeps the other indices valid.
  for (const size_t place : {ring.size() - 1, a.size() + 1, a.size(), size_t{0}})
    DropIfStraight(ring, place);
  return ring;
}

}  // namespace

size_t CutRegion::PointCount() const {
  size_t count = 0;
  for (const Polygon& ring : rings) count += ring.size();
  return count;
}

std::optional<CornerIndex> FirstReflex(const CutRegion& region, CornerIndex from) {
  for (size_t r = from.ring; r < region.rings.size(); ++r) {
    const Polygon& ring = region.rings[r];
    for (size_t i = r == from.ring ? from.point : 0; i < ring.size(); ++i)
      if (IsReflex(ring, i)) return CornerIndex{r, i};
  }
  return std::nullopt;
}

std::vector<CutRegion> CutAlong(CutRegion region, CornerIndex a, CornerIndex b) {
  std::vector<Polygon> others;
  for (size_t r = 0; r < region.rings.size(); ++r)
    if (r != a.ring && r != b.ring) others.push_back(std::move(region.rings[r]));
  const bool outer = a.ring == 0 || b.ring == 0;

  if (a.ring != b.ring) {
    Polygon joined = Joined(region.rings[a.ring], a.point, region.rings[b.ring], b.point);
    CutRegion whole;
    // The outer ring is others[0] unless ring a or b is the outer ring.
    if (outer) whole.rings.push_back(std::move(joined));
    std::move(others.begin(), others.end(), std::back_inserter(whole.rings));
    if (!outer) whole.rings.push_back(std::move(joined));
    return {std::move(whole)};
  }

  const Polygon& ring = region.rings[a.ring];
  Polygon first = ClosedChain(ring, a.point, b.point);
  Polygon second = ClosedChain(ring, b.point, a.point);
  std::vector<CutRegion> regions(2);
  size_t next = 0;
  if (outer) {
    regions[0].rings.push_back(std::move(first));
    regions[1].rings.push_back(std::move(second));
  } else {
    // The cut closes a bay of a hole: the bay becomes a region, and the other ring remains a hole.
    if (SignedArea(first) < 0) std::swap(first, second);
    regions[0].rings.push_back(std::move(first));
    regions[1].rings.push_back(std::move(others[0]));
    regions[1].rings.push_back(std::move(second));
    next = 1;
  }
  for (; next < others.size(); ++next) {
    const bool in_first = LiesInside(others[next], regions[0].rings[0]);
    regions[in_first ? 0 : 1].rings.push_back(std::move(others[next]));
  }
  return regions;
}

}  // namespace slicefarm::exposure
