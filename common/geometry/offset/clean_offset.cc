#include "common/geometry/offset/clean_offset.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/arrangement.h"
#include "common/geometry/boolean/by_island.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/offset/swept_curve.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/simple_rings.h"
#include "common/geometry/vector.h"

namespace slicefarm {
namespace {

/// Length below which a moved edge is removed if possible.
constexpr double kLeastEdgeNm = 100;
/// Tolerance for rounding: distance by which the line of a removed edge may be behind the meeting
/// point of its neighbours.
constexpr double kRoundingNm = 0.01;
/// 1 + cos of the turn at which a miter is twice as long as the distance; this is a corner of 60
/// degrees.
constexpr double kSharpest = 0.5;

/// An edge of a ring that moves. Positions are relative to the ring's first point.
struct MovingEdge {
  Vector2 origin;     ///< start of the edge before it moved
  Vector2 direction;  ///< unit vector; the island is to the left
  Vector2 start;      ///< current ends of the edge
  Vector2 end;
  int previous = 0;
  int next = 0;
  bool gone = false;

  Vector2 Normal() const { return TurnedLeft(direction); }
  double Length() const { return Dot(end - start, direction); }
};

/// Moves the edges of one ring to their left by a distance, which may be negative.
class RingOffset {
 public:
  RingOffset(const Polygon& ring, double left)
      : left_(left), turn_sign_(left >= 0 ? 1 : -1), base_(ring[0]) {
    edges_.reserve(ring.size());
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point from = ring[i], to = ring[i + 1 == ring.size() ? 0 : i + 1];
      const Point d = to - from;
      const double length = Norm(d);
      if (length == 0) continue;
      MovingEdge& edge = edges_.emplace_back();
      edge.origin = {static_cast<double>(from.x - base_.x), static_cast<double>(from.y - base_.y)};
      edge.direction = {static_cast<double>(d.x) / length, static_cast<double>(d.y) / length};
    }
    count_ = static_cast<int>(edges_.size());
    for (int i = 0; i < count_; ++i) {
      edges_[i].previous = i == 0 ? count_ - 1 : i - 1;
      edges_[i].next = i + 1 == count_ ? 0 : i + 1;
    }
  }

  /// Sets `ring` to the moved ring. Returns false if the ring changes more than a clean offset
  /// allows.
  bool Move(Polygon& ring) {
    if (count_ < 3) return false;
    for (MovingEdge& edge : edges_)
      if (!MeetAtCorner(edge, edges_[edge.next])) return false;
    if (!DropShortEdges()) return false;
    ring.clear();
    for (const MovingEdge& edge : edges_) {
      if (edge.gone) continue;
      Append(edge.start, ring);
      Append(edge.end, ring);
    }
    if (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    return ring.size() >= 3;
  }

  bool HasTips() const {
    return std::any_of(edges_.begin(), edges_.end(), [&](const MovingEdge& edge) {
      if (edge.gone) return false;
      const Vector2 next = edges_[edge.next].direction;
      return Cross(edge.direction, next) > 0 && 1 + Dot(edge.direction, next) < kSharpest;
    });
  }

 private:
  void Append(const Vector2& v, Polygon& ring) const {
    const Point p{base_.x + std::llround(v.x()), base_.y + std::llround(v.y())};
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  }

  /// Sets the meeting point of two edges that share a corner, after the move. At a sharp corner
  /// that the edges move away from, the edges get separate ends, which form a square cut.
  bool MeetAtCorner(MovingEdge& e, MovingEdge& f) const {
    const Vector2 corner = f.origin;
    const double straightness = 1 + Dot(e.direction, f.direction);
    if (straightness < 1e-9) return false;  // the ring reverses its direction here
    const bool closing = turn_sign_ * Cross(e.direction, f.direction) > 0;
    if (!closing && straightness < kSharpest) {
      const double turn = Acos(std::max(-1.0, straightness - 1));
      const double reach = std::abs(left_) * Tan(turn / 4);
      e.end = corner + left_ * e.Normal() + reach * e.direction;
      f.start = corner + left_ * f.Normal() - reach * f.direction;
    } else {
      e.end = f.start = corner + left_ / straightness * (e.Normal() + f.Normal());
    }
    return true;
  }

  bool DropShortEdges() {
    std::vector<int> open;
    for (int i = 0; i < static_cast<int>(edges_.size()); ++i)
      if (edges_[i].Length() < kLeastEdgeNm) open.push_back(i);
    while (!open.empty()) {
      MovingEdge& edge = edges_[open.back()];
      open.pop_back();
      if (edge.gone || edge.Length() >= kLeastEdgeNm) continue;
      if (!Drop(edge)) {
        if (edge.Length() < 0) return false;
        continue;
      }
      for (const int neighbour : {edge.previous, edge.next})
        if (edges_[neighbour].Length() < kLeastEdgeNm) open.push_back(neighbour);
    }
    return true;
  }

  /// Removes an edge, and lets its two neighbours meet each other. Succeeds only if both neighbours
  /// approach the edge and meet behind its line. Then the edge has no effect on the result.
  bool Drop(MovingEdge& edge) {
    MovingEdge &before = edges_[edge.previous], &after = edges_[edge.next];
    const double turn = Cross(before.direction, after.direction);
    if (count_ <= 3 || turn_sign_ * turn < 1e-6 ||
        turn_sign_ * Cross(before.direction, edge.direction) < 0 ||
        turn_sign_ * Cross(edge.direction, after.direction) < 0) {
      return false;
    }
    const Vector2 from = before.origin + left_ * before.Normal();
    const Vector2 to = after.origin + left_ * after.Normal();
    const Vector2 meet = from + Cross(to - from, after.direction) / turn * before.direction;
    const double beyond = turn_sign_ * (Dot(meet - edge.origin, edge.Normal()) - left_);
    if (beyond < -kRoundingNm) return false;
    before.end = after.start = meet;
    before.next = edge.next;
    after.previous = edge.previous;
    edge.gone = true;
    --count_;
    return true;
  }

  double left_;
  int turn_sign_;  ///< sign of the turns at corners that the edges move towards
  Point base_;
  int count_ = 0;  ///< number of remaining edges
  std::vector<MovingEdge> edges_;
};

/// Returns true if the holes are inside their outer ring and no hole is inside another. REQUIRES:
/// rings do not cross.
bool IsNested(const PolygonWithHoles& island) {
  if (SignedArea(island.outer) <= 0) return false;
  std::vector<Box> boxes;
  for (size_t i = 0; i < island.holes.size(); ++i) {
    const Polygon& hole = island.holes[i];
    if (SignedArea(hole) >= 0 || Locate(hole[0], island.outer) != Side::kInside) return false;
    boxes.push_back(Bounds(hole));
    for (size_t j = 0; j < i; ++j) {
      if (!boxes[i].Intersects(boxes[j])) continue;
      if (Locate(hole[0], island.holes[j]) != Side::kOutside ||
          Locate(island.holes[j][0], hole) != Side::kOutside) {
        return false;
      }
    }
  }
  return true;
}

bool AreApart(const MultiPolygon& islands) {
  std::vector<Box> boxes;
  for (size_t i = 0; i < islands.size(); ++i) {
    boxes.push_back(Bounds(islands[i].outer));
    for (size_t j = 0; j < i; ++j) {
      if (!boxes[i].Intersects(boxes[j])) continue;
      if (Locate(islands[i].outer[0], islands[j]) != Side::kOutside ||
          Locate(islands[j].outer[0], islands[i]) != Side::kOutside) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::optional<CleanOffset> TryOffset(const MultiPolygon& polygons, Coord distance_nm) {
  CleanOffset result;
  result.polygons.reserve(polygons.size());
  const auto move = [&](const Polygon& from, Polygon& to) {
    if (from.size() < 3) return false;
    RingOffset ring(from, static_cast<double>(-distance_nm));
    if (!ring.Move(to)) return false;
    result.has_tips |= ring.HasTips();
    return true;
  };
  for (const PolygonWithHoles& island : polygons) {
    PolygonWithHoles& moved = result.polygons.emplace_back();
    if (!move(island.outer, moved.outer)) return std::nullopt;
    moved.holes.resize(island.holes.size());
    for (size_t i = 0; i < island.holes.size(); ++i)
      if (!move(island.holes[i], moved.holes[i])) return std::nullopt;
  }
  std::vector<const Polygon*> rings;
  ForEachRing(result.polygons, [&](const Polygon& ring) { rings.push_back(&ring); });
  if (!AreSimple(rings)) return std::nullopt;
  for (const PolygonWithHoles& island : result.polygons)
    if (!IsNested(island)) return std::nullopt;
  if (!AreApart(result.polygons)) return std::nullopt;
  Canonicalize(result.polygons);
  return result;
}

std::optional<MultiPolygon> TryErode(const PolygonWithHoles& island, Coord distance_nm) {
  std::vector<internal::GroupedRing> rings;
  const auto append = [&](const Polygon& ring) {
    internal::SweptCurve curve = internal::SweepInwards(ring, static_cast<double>(distance_nm));
    if (curve.points.size() < 3) return false;
    rings.push_back({std::move(curve.points)});
    return true;
  };
  if (!append(island.outer)) return std::nullopt;
  for (const Polygon& hole : island.holes)
    if (!append(hole)) return std::nullopt;
  return internal::TryWindingRegion(rings, 1);
}

MultiPolygon FastOffset(const MultiPolygon& polygons, Coord distance_nm) {
  if (distance_nm == 0) return polygons;
  const auto offset = [&](const MultiPolygon& part) {
    if (auto clean = TryOffset(part, distance_nm)) return std::move(clean->polygons);
    if (distance_nm < 0)
      if (auto eroded = TryErode(part[0], -distance_nm)) return *std::move(eroded);
    return Offset(part, distance_nm);
  };
  return distance_nm > 0 ? offset(polygons) : internal::ByIsland(polygons, offset);
}

}  // namespace slicefarm
