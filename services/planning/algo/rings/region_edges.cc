#include "services/planning/algo/rings/region_edges.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

constexpr Coord kSquareNm = 1 * kNmPerMm;

bool Holds(const Box& outer, const Box& inner) {
  return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.max.x >= inner.max.x &&
         outer.max.y >= inner.max.y;
}

}  // namespace

RegionEdges::RegionEdges(const MultiPolygon& region) : index_(region, kSquareNm) {
  int32_t edges = 0;
  ForEachRing(region, [&](const Polygon& ring) {
    first_edge_.push_back(edges);
    edges += static_cast<int32_t>(ring.size());
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point before = ring[i == 0 ? ring.size() - 1 : i - 1];
      const Point next = ring[i + 1 == ring.size() ? 0 : i + 1];
      reflex_.push_back(Cross(ring[i] - before, next - ring[i]) < 0);
    }
  });
  first_edge_.push_back(edges);
}

void RegionEdges::LookAt(int32_t number, Point to, Best& best) const {
  const Edge& edge = index_.At(number);
  const Point along = edge.b - edge.a, away = to - edge.a;
  const double length2 = SquaredNorm(along);
  const double share = length2 > 0 ? std::clamp(Dot(along, away) / length2, 0.0, 1.0) : 0.0;
  const double dx = static_cast<double>(away.x) - share * static_cast<double>(along.x);
  const double dy = static_cast<double>(away.y) - share * static_cast<double>(along.y);
  const double distance2 = dx * dx + dy * dy;
  if (distance2 > best.distance2) return;
  if (distance2 == best.distance2 && best.edge >= 0 && number >= best.edge) return;
  best = {distance2, number, share};
}

std::optional<RegionEdges::Hit> RegionEdges::Nearest(Point to, Coord reach_nm) const {
  const Box& bounds = index_.bounds();
  if (index_.size() == 0 || !bounds.Grown(reach_nm).Intersects({to, to})) return std::nullopt;
  const auto reach = static_cast<double>(reach_nm);
  Best best{reach * reach, -1, 0};
  // Searches in growing boxes. Edges outside the box are farther away than its half width. Most
  // queried points are close to an edge.
  for (Coord half = std::min(index_.square_nm() / 8, reach_nm);;) {
    const Box box = Box{to, to}.Grown(half);
    index_.ForEachNear(box, [&](int32_t edge) { LookAt(edge, to, best); });
    if (half == reach_nm || Holds(box, bounds)) break;
    const double seen = static_cast<double>(half), least = std::sqrt(best.distance2);
    if (best.edge >= 0 && least <= seen) break;
    // The best edge so far is outside the box. A nearer edge is within a box of its distance.
    const Coord next = best.edge >= 0 ? static_cast<Coord>(least) + 1 : 4 * half;
    half = std::min(next, reach_nm);
  }
  if (best.edge < 0) return std::nullopt;
  const Edge& edge = index_.At(best.edge);
  return Hit{edge.ring,
             edge.edge,
             best.share,
             NearestOnSegment(to, edge.a, edge.b),
             std::sqrt(best.distance2),
             IsInside(to, best)};
}

bool RegionEdges::IsInside(Point p, const Best& best) const {
  const Edge& edge = index_.At(best.edge);
  if (best.share > 0 && best.share < 1) return Cross(edge.b - edge.a, p - edge.a) >= 0;
  if (best.distance2 == 0) return true;
  // The nearest point is a corner. The queried point is inside only if this is a reflex corner.
  if (best.share == 0) return reflex_[static_cast<size_t>(best.edge)];
  const auto ring = static_cast<size_t>(edge.ring);
  const bool is_last = best.edge + 1 == first_edge_[ring + 1];
  return reflex_[static_cast<size_t>(is_last ? first_edge_[ring] : best.edge + 1)];
}

std::vector<int32_t> RegionEdges::EdgesIn(const Box& box) const {
  std::vector<int32_t> edges;
  if (index_.size() == 0) return edges;
  index_.ForEachNear(box, [&](int32_t edge) { edges.push_back(edge); });
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool RegionEdges::IsInside(Point p) const {
  const Box& bounds = index_.bounds();
  if (!bounds.Intersects({p, p})) return false;
  bool inside = false;
  for (const int32_t number : EdgesIn({{bounds.min.x, p.y}, p})) {
    const Edge& edge = index_.At(number);
    if ((edge.a.y > p.y) == (edge.b.y > p.y)) continue;
    // Tests whether the edge is to the left of the point.
    const bool left = Cross(edge.b - edge.a, p - edge.a) > 0;
    if (left != (edge.b.y > edge.a.y)) inside = !inside;
  }
  return inside;
}

std::vector<RegionEdges::Edge> RegionEdges::Near(Point a, Point b) const {
  Box box;
  box.Add(a), box.Add(b);
  std::vector<Edge> edges;
  for (const int32_t number : EdgesIn(box)) edges.push_back(index_.At(number));
  return edges;
}

}  // namespace slicefarm::planning
