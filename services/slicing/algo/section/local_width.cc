#include "services/slicing/algo/section/local_width.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"

namespace slicefarm::slicing {
namespace {

Vector2 Normalized(Vector2 d) {
  const double length = Hypot(d.x(), d.y());
  return d / length;
}

/// Sets the middle and the half angle of all normals of an edge and its reflex corners.
void SetNormals(OutlineEdge& edge) {
  Vector2 sum = edge.inward;
  if (edge.reflex_from) sum += edge.inward_before;
  if (edge.reflex_to) sum += edge.inward_after;
  edge.middle_rad = Atan2(sum.y(), sum.x());
  const auto widen = [&](Vector2 normal) {
    const double off =
        std::remainder(Atan2(normal.y(), normal.x()) - edge.middle_rad, 2 * std::numbers::pi);
    edge.half_rad = std::max(edge.half_rad, std::abs(off) + 1e-6);
  };
  widen(edge.inward);
  if (edge.reflex_from) widen(edge.inward_before);
  if (edge.reflex_to) widen(edge.inward_after);
}

/// Returns true if a disc may touch both edges on sides that count as opposite.
bool MayBeOpposite(const OutlineEdge& a, const OutlineEdge& b, OppositeAngles angles) {
  const double off =
      std::remainder(a.middle_rad - b.middle_rad - std::numbers::pi, 2 * std::numbers::pi);
  return std::abs(off) <= a.half_rad + b.half_rad + Acos(angles.begin_cos);
}

void AppendEdges(const Polygon& ring, std::vector<OutlineEdge>& edges) {
  const size_t first = edges.size();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    if (from == to) continue;
    const Vector2 along = Normalized(ToVector(to - from));
    edges.push_back({.from = from, .to = to, .along = along, .inward = TurnedLeft(along)});
  }
  const size_t count = edges.size() - first;
  for (size_t i = 0; i < count; ++i) {
    OutlineEdge& edge = edges[first + i];
    edge.next = static_cast<int32_t>(first + (i + 1) % count);
    OutlineEdge& next = edges[edge.next];
    edge.reflex_to = next.reflex_from = Cross(edge.along, next.along) < 0;
    edge.inward_after = next.inward;
    next.inward_before = edge.inward;
  }
  for (size_t i = first; i < edges.size(); ++i) SetNormals(edges[i]);
}

/// Calls visit(diameter, cosine) for discs that touch the outline at p with normal n and also touch
/// an edge or its reflex ends. `cosine` belongs to the angle between the two touched sides.
template <typename Visit>
void ForEachDisc(Point p, Vector2 n, const OutlineEdge& edge, Visit visit) {
  if (p == edge.from || p == edge.to) {  // a convex corner has no disc, a reflex one any disc
    if (!(p == edge.from ? edge.reflex_from : edge.reflex_to)) visit(0.0, -Dot(n, edge.inward));
    return;
  }
  const Vector2 to_from = ToVector(edge.from - p);
  // This disc touches the edge's line: its centre has the same distance from p and from the line.
  const double height = -Dot(to_from, edge.inward);
  const double turned = 1 - Dot(n, edge.inward);
  if (height > 0 && turned > 1e-9) {
    const double radius = height / turned;
    const double foot = Dot(n * radius - to_from, edge.along);
    if (foot >= 0 && foot <= Dot(ToVector(edge.to - edge.from), edge.along))
      return visit(2 * radius, turned - 1);
  }
  // No disc within the material touches a corner that is not reflex.
  for (const auto& [end, reflex] :
       {std::pair{edge.from, edge.reflex_from}, std::pair{edge.to, edge.reflex_to}}) {
    const Vector2 d = ToVector(end - p);
    const double forward = Dot(d, n), square = Dot(d, d);
    if (!reflex || forward <= 0) continue;
    const double radius = square / forward / 2;
    visit(2 * radius, Dot(d - n * radius, n) / radius);
  }
}

/// Returns true if a direction is within the fan of normals of a reflex corner: from `first`
/// clockwise to `last`.
bool IsBetween(Vector2 first, Vector2 d, Vector2 last) {
  return Cross(first, d) <= 0 && Cross(d, last) <= 0 && Dot(first + last, d) > 0;
}

Point Nearest(Point p, const OutlineEdge& edge) {
  const double length = Dot(ToVector(edge.to - edge.from), edge.along);
  const double t = Dot(ToVector(p - edge.from), edge.along);
  if (t <= 0) return edge.from;
  if (t >= length) return edge.to;
  return {edge.from.x + std::llround(edge.along.x() * t),
          edge.from.y + std::llround(edge.along.y() * t)};
}

/// Calls visit(normal) for the normals at a point of an edge for which the distance to another edge
/// is measured: one normal, or three representative ones at a reflex corner.
template <typename Visit>
void ForEachNormal(const OutlineEdge& edge, Point p, const OutlineEdge& other, Visit visit) {
  visit(edge.inward);
  const bool at_from = p == edge.from && edge.reflex_from;
  if (!at_from && !(p == edge.to && edge.reflex_to)) return;
  const Vector2 first = at_from ? edge.inward_before : edge.inward;
  const Vector2 last = at_from ? edge.inward : edge.inward_after;
  visit(at_from ? first : last);
  const Point q = Nearest(p, other);
  if (q == p) return;
  const Vector2 d = Normalized(ToVector(q - p));
  if (IsBetween(first, d, last)) visit(d);
}

}  // namespace

LocalWidth::LocalWidth(const PolygonWithHoles& island, Coord limit_nm, OppositeAngles angles)
    : limit_nm_(limit_nm), angles_(angles) {
  AppendEdges(island.outer, edges_);
  for (const Polygon& hole : island.holes) AppendEdges(hole, edges_);
  for (size_t i = 0; i < edges_.size(); ++i) {
    ForEachCell(edges_[i].from, edges_[i].to,
                [&](Cell cell) { cells_.emplace_back(cell, static_cast<int32_t>(i)); });
  }
  std::sort(cells_.begin(), cells_.end());
  cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
}

LocalWidth::Cell LocalWidth::CellOf(double x, double y) const {
  const auto size = static_cast<double>(limit_nm_);
  return {static_cast<int64_t>(std::floor(x / size)), static_cast<int64_t>(std::floor(y / size))};
}

/// Visits the cells of points along the segment. The points are at most a cell's size apart, so
/// each point of the segment is within half a cell's size of one of them.
template <typename Visit>
void LocalWidth::ForEachCell(Point from, Point to, Visit visit) const {
  const Vector2 d = ToVector(to - from);
  const int steps = 1 + static_cast<int>(Hypot(d.x(), d.y()) / static_cast<double>(limit_nm_));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    visit(CellOf(static_cast<double>(from.x) + d.x() * t, static_cast<double>(from.y) + d.y() * t));
  }
}

std::vector<int32_t> LocalWidth::Opposite(const OutlineEdge& edge, Point from, Point to) const {
  std::vector<int32_t> found;
  ForEachCell(from, to, [&](Cell cell) {
    for (int64_t x = cell.first - 2; x <= cell.first + 2; ++x) {
      auto it = std::lower_bound(cells_.begin(), cells_.end(),
                                 std::pair<Cell, int32_t>{{x, cell.second - 2}, -1});
      for (; it != cells_.end() && it->first <= Cell{x, cell.second + 2}; ++it)
        found.push_back(it->second);
    }
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase_if(found, [&](int32_t i) {
    return &edges_[i] == &edge || !MayBeOpposite(edge, edges_[i], angles_);
  });
  return found;
}

double LocalWidth::At(const OutlineEdge& edge, Point p, std::span<const int32_t> opposite) const {
  auto width = static_cast<double>(limit_nm_);
  const auto narrow = [&](double diameter, double cosine) {
    const double share = (cosine - angles_.begin_cos) / (angles_.full_cos - angles_.begin_cos);
    if (share > 0.01) width = std::min(width, diameter / std::min(share, 1.0));
  };
  for (const int32_t i : opposite) {
    ForEachNormal(edge, p, edges_[i],
                  [&](Vector2 normal) { ForEachDisc(p, normal, edges_[i], narrow); });
  }
  return width;
}

}  // namespace slicefarm::slicing
