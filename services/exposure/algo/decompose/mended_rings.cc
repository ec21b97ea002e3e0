#include "services/exposure/algo/decompose/mended_rings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/simple_rings.h"
#include "services/exposure/algo/decompose/exact_vector.h"

namespace slicefarm::exposure {
namespace {

struct Edge {
  Point a, b;
  std::vector<Point> touches = {};  ///< corners of other edges that are on this edge

  Coord Left() const { return std::min(a.x, b.x); }
  Coord Right() const { return std::max(a.x, b.x); }
  bool StrictlyHas(Point p) const { return p != a && p != b && OnSegment(p, a, b); }
};

absl::Status Malformed(const char* what, Point at) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("the outline's rings {} near ({:.6f}, {:.6f}) mm", what,
                               ToMm(static_cast<double>(at.x)), ToMm(static_cast<double>(at.y))),
                   {{"x_nm", std::to_string(at.x)}, {"y_nm", std::to_string(at.y)}});
}

bool DoEdgesCross(const Edge& e, const Edge& f) {
  return Orientation(e.a, e.b, f.a) * Orientation(e.a, e.b, f.b) < 0 &&
         Orientation(f.a, f.b, e.a) * Orientation(f.a, f.b, e.b) < 0;
}

/// Sets `touches` of each edge. Returns an error if edges cross.
absl::Status FindTouches(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.Left() < f.Left(); });
  for (size_t i = 0; i < edges.size(); ++i) {
    for (size_t j = i + 1; j < edges.size() && edges[j].Left() <= edges[i].Right(); ++j) {
      Edge &e = edges[i], &f = edges[j];
      if (std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) ||
          std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y))
        continue;
      if (DoEdgesCross(e, f)) return Malformed("cross", f.a);
      for (const Point p : {f.a, f.b})
        if (e.StrictlyHas(p)) e.touches.push_back(p);
      for (const Point p : {e.a, e.b})
        if (f.StrictlyHas(p)) f.touches.push_back(p);
    }
  }
  return absl::OkStatus();
}

/// Directed edge between two corners, without a corner between them.
struct DirectedEdge {
  Point from, to;
  bool used = false;

  friend bool operator<(const DirectedEdge& v, const DirectedEdge& w) {
    return v.from != w.from ? v.from < w.from : v.to < w.to;
  }
};

/// Divides edges where corners touch them, and removes pairs of opposite edges. Returns the
/// remaining edges, sorted.
absl::StatusOr<std::vector<DirectedEdge>> Divided(std::vector<Edge> edges) {
  std::vector<DirectedEdge> directed;
  for (Edge& edge : edges) {
    const auto from_start = [&](Point p, Point q) {
      return Distance(edge.a, p) < Distance(edge.a, q);
    };
    std::sort(edge.touches.begin(), edge.touches.end(), from_start);
    Point from = edge.a;
    for (const Point p : edge.touches) {
      if (p != from) directed.push_back({from, p});
      from = p;
    }
    directed.push_back({from, edge.b});
  }
  std::sort(directed.begin(), directed.end());
  std::vector<DirectedEdge> left;
  for (size_t i = 0; i < directed.size(); ++i) {
    if (i > 0 && !(directed[i - 1] < directed[i]))
      return Malformed("lie on each other", directed[i].from);
    if (!std::binary_search(directed.begin(), directed.end(),
                            DirectedEdge{directed[i].to, directed[i].from}))
      left.push_back(directed[i]);
  }
  return left;
}

/// Returns true if a clockwise turn from direction `from` meets `a` before `b`. REQUIRES: no two
/// directions are equal.
bool ComesFirst(Vector2 from, Vector2 a, Vector2 b) {
  const auto half = [&](Vector2 v) {  // 0: right of `from`; 1: opposite; 2: left
    const int side = CrossSign(from, v);
    return side < 0 ? 0 : side > 0 ? 2 : 1;
  };
  const int half_a = half(a), half_b = half(b);
  return half_a != half_b ? half_a < half_b : CrossSign(a, b) < 0;
}

/// Joins the edges into rings. At each corner, the ring continues with the first edge clockwise
/// from the edge on which it arrives, so that it crosses no other ring.
absl::StatusOr<std::vector<Polygon>> Followed(std::vector<DirectedEdge> edges) {
  const auto leaving = [&](Point p) {
    const auto first =
        std::lower_bound(edges.begin(), edges.end(), DirectedEdge{p, {INT64_MIN, INT64_MIN}});
    auto last = first;
    while (last != edges.end() && last->from == p) ++last;
    return std::span<DirectedEdge>(first, last);
  };
  std::vector<Polygon> rings;
  for (DirectedEdge& start : edges) {
    if (start.used) continue;
    Polygon ring;
    for (DirectedEdge* edge = &start; !edge->used;) {
      edge->used = true;
      ring.push_back(edge->from);
      const Vector2 back = ToVector(edge->from - edge->to);
      DirectedEdge* next = nullptr;
      for (DirectedEdge& other : leaving(edge->to)) {
        if (next == nullptr ||
            ComesFirst(back, ToVector(other.to - other.from), ToVector(next->to - next->from)))
          next = &other;
      }
      if (next == nullptr) return Malformed("are not closed", edge->to);
      edge = next;
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

/// Returns the side of `outer` on which a ring is. The ring may touch `outer`. Returns nullopt if
/// all its points are on `outer`.
std::optional<Side> SideOf(const Polygon& ring, const Polygon& outer) {
  for (const Point p : ring)
    if (const Side side = Locate(p, outer); side != Side::kBoundary) return side;
  return std::nullopt;
}

absl::StatusOr<MultiPolygon> Nested(std::vector<Polygon> rings) {
  MultiPolygon islands;
  std::vector<Polygon> holes;
  for (Polygon& ring : rings) {
    const double area = SignedArea(ring);
    if (area > 0) islands.push_back({std::move(ring), {}});
    if (area < 0) holes.push_back(std::move(ring));
  }
  for (Polygon& hole : holes) {
    PolygonWithHoles* owner = nullptr;
    for (PolygonWithHoles& island : islands) {
      if (SideOf(hole, island.outer) == Side::kInside &&
          (owner == nullptr || SignedArea(island.outer) < SignedArea(owner->outer)))
        owner = &island;
    }
    if (owner == nullptr) return Malformed("have the wrong orientation", hole[0]);
    owner->holes.push_back(std::move(hole));
  }
  return islands;
}

absl::Status CheckTurns(const MultiPolygon& islands) {
  for (const PolygonWithHoles& island : islands) {
    if (SignedArea(island.outer) < 0)
      return Malformed("have the wrong orientation", island.outer[0]);
    for (const Polygon& hole : island.holes)
      if (SignedArea(hole) > 0) return Malformed("have the wrong orientation", hole[0]);
  }
  return absl::OkStatus();
}

/// Returns true if a ring is on an island: inside the outer ring, and in none of the holes.
/// REQUIRES: the ring crosses no other ring.
bool LiesOn(const Polygon& ring, const PolygonWithHoles& island) {
  return SideOf(ring, island.outer) == Side::kInside &&
         std::ranges::none_of(island.holes, [&](const Polygon& hole) {
           return SideOf(ring, hole).value_or(Side::kInside) == Side::kInside;
         });
}

absl::Status CheckApart(const MultiPolygon& islands) {
  std::vector<std::pair<Box, const PolygonWithHoles*>> boxed;
  for (const PolygonWithHoles& island : islands) boxed.emplace_back(Bounds(island.outer), &island);
  std::ranges::stable_sort(boxed, {}, [](const auto& one) { return one.first.min.x; });
  for (size_t i = 0; i < boxed.size(); ++i) {
    const auto& [box, island] = boxed[i];
    for (size_t k = i + 1; k < boxed.size() && boxed[k].first.min.x <= box.max.x; ++k) {
      const auto& [other_box, other] = boxed[k];
      if (!box.Intersects(other_box)) continue;
      if (LiesOn(other->outer, *island)) return Malformed("overlap", other->outer[0]);
      if (LiesOn(island->outer, *other)) return Malformed("overlap", island->outer[0]);
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<MultiPolygon> MendedRings(MultiPolygon islands) {
  if (absl::Status status = CheckTurns(islands); !status.ok()) return status;
  std::vector<const Polygon*> rings;
  ForEachRing(islands, [&](const Polygon& ring) { rings.push_back(&ring); });
  if (AreSimple(rings)) {
    if (absl::Status status = CheckApart(islands); !status.ok()) return status;
    return islands;
  }
  std::vector<Edge> edges;
  for (const Polygon* ring : rings)
    for (size_t i = 0; i < ring->size(); ++i)
      if (const Edge edge{(*ring)[i], (*ring)[(i + 1) % ring->size()]}; edge.a != edge.b)
        edges.push_back(edge);
  if (absl::Status status = FindTouches(edges); !status.ok()) return status;
  auto paths = Divided(std::move(edges));
  if (!paths.ok()) return paths.status();
  auto followed = Followed(*std::move(paths));
  if (!followed.ok()) return followed.status();
  return Nested(*std::move(followed));
}

}  // namespace slicefarm::exposure
