#include "services/slicing/algo/placement/arranging/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::slicing {
namespace {

constexpr size_t kExactCorners = 40;
constexpr size_t kMostCorners = 200;
constexpr size_t kMostPieces = 12;
constexpr Coord kOutwards = 100'000;

bool InTriangle(Point p, Point a, Point b, Point c) {
  return Orientation(a, b, p) >= 0 && Orientation(b, c, p) >= 0 && Orientation(c, a, p) >= 0;
}

bool IsEar(const Polygon& ring, size_t i) {
  const size_t n = ring.size();
  const Point a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
  if (Orientation(a, b, c) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](Point p) {
    return p != a && p != b && p != c && InTriangle(p, a, b, c);
  });
}

/// Returns the triangles of a simple counter-clockwise ring; empty if the ring is not simple.
std::vector<Polygon> EarClipped(Polygon ring) {
  std::vector<Polygon> triangles;
  while (ring.size() > 3) {
    size_t ear = 0;
    while (ear < ring.size() && !IsEar(ring, ear)) ++ear;
    if (ear == ring.size()) return {};
    const size_t n = ring.size();
    triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    ring.erase(ring.begin() + ear);
  }
  triangles.push_back(std::move(ring));
  return triangles;
}

bool IsConvex(const Polygon& ring) {
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i)
    if (Orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) < 0) return false;
  return true;
}

/// Returns two pieces joined along a common edge. The result is empty if there is no common edge or
/// if the joined piece would not be convex.
Polygon JoinedConvex(const Polygon& a, const Polygon& b) {
  for (size_t i = 0; i < a.size(); ++i) {
    const auto match = std::find(b.begin(), b.end(), a[i]);
    if (match == b.end()) continue;
    const size_t j = match - b.begin();
    const size_t before = (j + b.size() - 1) % b.size();
    if (b[before] != a[(i + 1) % a.size()]) continue;
    Polygon joined;
    for (size_t k = 1; k <= a.size(); ++k) joined.push_back(a[(i + k) % a.size()]);
    for (size_t k = 1; k + 1 < b.size(); ++k) joined.push_back(b[(j + k) % b.size()]);
    return IsConvex(joined) ? joined : Polygon{};
  }
  return {};
}

std::vector<Polygon> Merged(std::vector<Polygon> pieces) {
  for (size_t i = 0; i < pieces.size(); ++i) {
    for (size_t j = 0; j < pieces.size();) {
      Polygon joined = i == j ? Polygon{} : JoinedConvex(pieces[i], pieces[j]);
      if (joined.empty()) {
        ++j;
        continue;
      }
      pieces[i] = std::move(joined);
      pieces.erase(pieces.begin() + j);
      if (j < i) --i;
      j = 0;
    }
  }
  return pieces;
}

/// Returns the outline as one simple ring, simplified outwards if it has many corners; empty if
/// this is impossible.
Polygon SimpleOutline(const Polygon& footprint) {
  const auto outer_of = [](const MultiPolygon& islands) {
    return islands.size() == 1 ? islands[0].outer : Polygon{};
  };
  const Polygon rings[] = {footprint};
  const MultiPolygon islands = Union(rings, FillRule::kNonZero);
  Polygon outer = outer_of(islands);
  if (outer.size() <= kExactCorners) {
    // Union rounds the crossings of edges. A ring without crossings keeps the area of the
    // footprint.
    return std::abs(SignedArea(outer)) == std::abs(SignedArea(footprint)) ? outer : Polygon{};
  }
  const Polygon grown = outer_of(Offset({{std::move(outer), {}}}, 2 * kOutwards));
  const Polygon simplified[] = {SimplifyRing(grown, kOutwards)};
  return outer_of(Union(simplified, FillRule::kNonZero));
}

}  // namespace

std::vector<Polygon> ConvexParts(const Polygon& footprint) {
  if (footprint.empty()) return {};
  const Polygon hull = ConvexHull(footprint);
  if (hull.size() < 3 || std::abs(SignedArea(footprint)) == SignedArea(hull)) return {hull};
  const Polygon outline = SimpleOutline(footprint);
  if (outline.size() < 3 || outline.size() > kMostCorners) return {hull};
  std::vector<Polygon> pieces = Merged(EarClipped(outline));
  if (pieces.empty() || pieces.size() > kMostPieces) return {hull};
  for (Polygon& piece : pieces) piece = ConvexHull(std::move(piece));
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

}  // namespace slicefarm::slicing
