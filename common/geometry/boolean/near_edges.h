#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

// Search for pairs of edges that may meet; private to common/geometry.

/// An edge with its bounding box.
struct BoxedEdge {
  Point from, to;
  Point min, max;
  int32_t ring = 0;   ///< index of the edge's ring, for the caller
  int32_t index = 0;  ///< index of the edge in its ring, for the caller
};

/// Appends the edges of a closed ring, in its order. The edges are filled in place: to copy one
/// just written takes longer than to make it.
inline void AppendBoxedEdges(const Polygon& points, int32_t ring, std::vector<BoxedEdge>& edges) {
  const size_t first = edges.size(), count = points.size();
  edges.resize(first + count);
  for (size_t i = 0; i < count; ++i) {
    const Point from = points[i], to = points[i + 1 == count ? 0 : i + 1];
    BoxedEdge& edge = edges[first + i];
    edge.from = from;
    edge.to = to;
    edge.min.x = std::min(from.x, to.x);
    edge.min.y = std::min(from.y, to.y);
    edge.max.x = std::max(from.x, to.x);
    edge.max.y = std::max(from.y, to.y);
    edge.ring = ring;
    edge.index = static_cast<int32_t>(i);
  }
}

/// Returns the axis for a sweep, as a member of Point. Along this axis, the boxes of the edges are
/// shorter in total, so that fewer of them overlap.
inline Coord Point::*SweepAxis(std::span<const BoxedEdge> a, std::span<const BoxedEdge> b = {}) {
  double x = 0, y = 0;
  for (const std::span<const BoxedEdge> edges : {a, b}) {
    for (const BoxedEdge& edge : edges) {
      x += static_cast<double>(edge.max.x - edge.min.x);
      y += static_cast<double>(edge.max.y - edge.min.y);
    }
  }
  return x <= y ? &Point::x : &Point::y;
}

/// Bounding box of an edge for a sweep. It is small, because a sweep reads many of them.
struct SweepSpan {
  Coord from = 0, to = 0;     ///< extent of the box along the sweep axis, in nm
  Coord least = 0, most = 0;  ///< extent of the box across the sweep axis, in nm
  const BoxedEdge* edge = nullptr;
};

/// Returns the indices of the edges, sorted by the start of their boxes along an axis; edges with
/// the same start keep their order.
inline std::vector<uint32_t> SweepOrder(std::span<const BoxedEdge> edges, Coord Point::*along) {
  std::vector<uint32_t> order(edges.size());
  if (edges.empty()) return order;
  Coord first = edges[0].min.*along, last = first;
  for (const BoxedEdge& edge : edges) {
    first = std::min(first, edge.min.*along);
    last = std::max(last, edge.min.*along);
  }
  const int index_bits = std::bit_width(edges.size());
  if (std::bit_width(static_cast<uint64_t>(last - first)) + index_bits > 64) {
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](uint32_t i) { return edges[i].min.*along; });
    return order;
  }
  // Numbers that hold the start and the index are sorted twice as fast as pairs.
  std::vector<uint64_t> keys(edges.size());
  for (size_t i = 0; i < edges.size(); ++i)
    keys[i] = static_cast<uint64_t>(edges[i].min.*along - first) << index_bits | i;
  std::sort(keys.begin(), keys.end());
  const uint64_t index_mask = (uint64_t{1} << index_bits) - 1;
  for (size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<uint32_t>(keys[i] & index_mask);
  return order;
}

/// Returns the boxes of edges for a sweep along an axis, sorted by their start along the axis.
inline std::vector<SweepSpan> SweepSpans(std::span<const BoxedEdge> edges, Coord Point::*along) {
  Coord Point::*const across = along == &Point::x ? &Point::y : &Point::x;
  const std::vector<uint32_t> order = SweepOrder(edges, along);
  std::vector<SweepSpan> spans(edges.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const BoxedEdge& edge = edges[order[i]];
    SweepSpan& span = spans[i];
    span.from = edge.min.*along;
    span.to = edge.max.*along;
    span.least = edge.min.*across;
    span.most = edge.max.*across;
    span.edge = &edge;
  }
  return spans;
}

/// Limit on the pairs that a search tests: kPairsAnyway (a few milliseconds) plus kPairsPerEdge for
/// each edge. Beyond the limit, the search fails, because a complete sweep would be faster.
inline constexpr size_t kPairsAnyway = 1'000'000;
inline constexpr size_t kPairsPerEdge = 64;

/// Calls visit(edge of e, edge of f) for each f in `spans`, from index `from` on, with a box that
/// meets the box of e. Each test of a pair reduces `budget` by one. Returns false as soon as
/// `visit` returns false, or if `budget` is used up. REQUIRES: `spans` is sorted as by SweepSpans.
template <typename Visit>
bool ForEachMeeting(const SweepSpan& e, const std::vector<SweepSpan>& spans, size_t from,
                    size_t& budget, const Visit& visit) {
  for (size_t i = from; i < spans.size() && spans[i].from <= e.to; ++i) {
    if (budget-- == 0) return false;
    const SweepSpan& f = spans[i];
    // One branch, because most boxes are on one side or the other, at random.
    if (static_cast<int>(f.most < e.least) | static_cast<int>(f.least > e.most)) continue;
    if (!visit(*e.edge, *f.edge)) return false;
  }
  return true;
}

/// Calls visit(e, f) once for each pair of edges with intersecting boxes. Stops and returns false
/// if `visit` returns false, or if the search tests more pairs than the limit allows.
template <typename Visit>
bool ForEachNearPair(std::span<const BoxedEdge> edges, const Visit& visit) {
  const std::vector<SweepSpan> spans = SweepSpans(edges, SweepAxis(edges));
  size_t budget = kPairsAnyway + kPairsPerEdge * edges.size();
  for (size_t i = 0; i < spans.size(); ++i)
    if (!ForEachMeeting(spans[i], spans, i + 1, budget, visit)) return false;
  return true;
}

/// Calls visit(e, f) like the function above, but only for pairs of an edge of `a` and an edge of
/// `b`. `e` may be of either set.
template <typename Visit>
bool ForEachNearPair(std::span<const BoxedEdge> a, std::span<const BoxedEdge> b,
                     const Visit& visit) {
  Coord Point::*const along = SweepAxis(a, b);
  const std::vector<SweepSpan> of_a = SweepSpans(a, along), of_b = SweepSpans(b, along);
  size_t budget = kPairsAnyway + kPairsPerEdge * (a.size() + b.size());
  for (size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
    const bool a_first = of_a[i].from <= of_b[j].from;
    if (!(a_first ? ForEachMeeting(of_a[i++], of_b, j, budget, visit)
                  : ForEachMeeting(of_b[j++], of_a, i, budget, visit)))
      return false;
  }
  return true;
}

}  // namespace slicefarm::internal
