#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Finds pairs of edges that may meet; private to common/geometry.

/// An edge with its box.
struct BoxedEdge {
  Point from, to;
  Point min, max;
  int32_t ring = 0;   ///< set and used by the caller only
  int32_t index = 0;  ///< set and used by the caller only
};

inline BoxedEdge MakeBoxedEdge(Point from, Point to, int32_t ring, int32_t index) {
  const auto [left, right] = std::minmax(from.x, to.x);
  const auto [low, high] = std::minmax(from.y, to.y);
  return {from, to, {left, low}, {right, high}, ring, index};
}

/// Appends the edges of a closed ring, in its order.
inline void AppendBoxedEdges(const Polygon& points, int32_t ring, std::vector<BoxedEdge>& edges) {
  for (size_t i = 0; i < points.size(); ++i) {
    const Point to = points[i + 1 == points.size() ? 0 : i + 1];
    edges.push_back(MakeBoxedEdge(points[i], to, ring, static_cast<int32_t>(i)));
  }
}

/// Returns the axis along which fewer edges overlap, as a member of Point.
inline Coord Point::*SweepAxis(const std::vector<BoxedEdge>& edges) {
  double x = 0, y = 0;
  for (const BoxedEdge& edge : edges) {
    x += static_cast<double>(edge.max.x - edge.min.x);
    y += static_cast<double>(edge.max.y - edge.min.y);
  }
  return x <= y ? &Point::x : &Point::y;
}

/// Number of pairs that the search always allows (a few milliseconds), in addition to a number per
/// edge. With more pairs the search gives up, because it would not be faster than a sweep.
inline constexpr size_t kPairsAnyway = 1'000'000;
inline constexpr size_t kPairsPerEdge = 64;

/// Calls visit(e, f) for all pairs of edges with intersecting boxes. Stops and returns false if
/// visit returns false, or if there are too many pairs. Reorders the edges. Cost: O(n log n + pairs
/// that overlap along the axis).
template <typename Visit>
bool ForEachNearPair(std::vector<BoxedEdge>& edges, Visit visit) {
  Coord Point::*const along = SweepAxis(edges);
  Coord Point::*const across = along == &Point::x ? &Point::y : &Point::x;
  std::sort(edges.begin(), edges.end(), [along](const BoxedEdge& a, const BoxedEdge& b) {
    return a.min.*along < b.min.*along;
  });
  size_t budget = kPairsAnyway + kPairsPerEdge * edges.size();
  for (size_t i = 0; i < edges.size(); ++i) {
    const BoxedEdge& e = edges[i];
    for (size_t j = i + 1; j < edges.size() && edges[j].min.*along <= e.max.*along; ++j) {
      if (budget-- == 0) return false;
      const BoxedEdge& f = edges[j];
      if (f.max.*across < e.min.*across || f.min.*across > e.max.*across) continue;
      if (!visit(e, f)) return false;
    }
  }
  return true;
}

/// Calls visit(edge of a, edge of b) for all pairs of one edge of `a` and one edge of `b` with
/// intersecting boxes. Stops as the function above does.
template <typename Visit>
bool ForEachNearPair(std::vector<BoxedEdge>& a, std::vector<BoxedEdge>& b, Visit visit) {
  Coord Point::*const along = SweepAxis(a);
  Coord Point::*const across = along == &Point::x ? &Point::y : &Point::x;
  for (auto* edges : {&a, &b}) {
    std::sort(edges->begin(), edges->end(), [along](const BoxedEdge& e, const BoxedEdge& f) {
      return e.min.*along < f.min.*along;
    });
  }
  size_t budget = kPairsAnyway + kPairsPerEdge * (a.size() + b.size());
  const auto sweep = [&](const BoxedEdge& e, const std::vector<BoxedEdge>& others, size_t from,
                         auto call) {
    for (size_t k = from; k < others.size() && others[k].min.*along <= e.max.*along; ++k) {
      if (budget-- == 0) return false;
      const BoxedEdge& f = others[k];
      if (f.max.*across < e.min.*across || f.min.*across > e.max.*across) continue;
      if (!call(e, f)) return false;
    }
    return true;
  };
  const auto swapped = [&](const BoxedEdge& f, const BoxedEdge& e) { return visit(e, f); };
  for (size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].min.*along <= b[j].min.*along) {
      if (!sweep(a[i++], b, j, visit)) return false;
    } else {
      if (!sweep(b[j++], a, i, swapped)) return false;
    }
  }
  return true;
}

}  // namespace slicefarm::internal
