#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::ordering {

/// Edges of rings and lines, found by horizontal strips: what does a segment meet of them, and is a
/// point inside the rings? Answers are exact.
///
/// Each strip holds the edges that reach into it, by their left ends; strips are as high as an edge
/// on average, so that all strips together hold at most about three times the edges.
/// Cost: O(n log n) to build; a segment costs the strips that it goes through, and in each the edges
/// to the left of its right end there.
class EdgeStrips {
 public:
  static constexpr uint32_t kAll = std::numeric_limits<uint32_t>::max();

  /// Add all, then Build, then ask.
  void AddRing(std::span<const Point> ring, uint32_t order = 0);
  void AddLine(std::span<const Point> line, uint32_t order = 0);
  void Build();

  bool empty() const { return edges_.empty(); }

  /// Whether the segment ab shares a point with an edge.
  bool Meets(Point a, Point b) const;
  /// Whether ab and an edge of an order below `before` cross each other, in the inside of both.
  bool Crosses(Point a, Point b, uint32_t before = kAll) const;
  /// Whether p is inside an odd number of the rings. REQUIRES: it lies on none of them.
  bool Surrounds(Point p) const;

 private:
  struct Edge {
    Point low, high;  ///< by y
    uint32_t order;

    Coord left() const { return low.x < high.x ? low.x : high.x; }
    Coord right() const { return low.x < high.x ? high.x : low.x; }
  };

  void Add(Point a, Point b, uint32_t order);
  size_t StripOf(Coord y) const;
  std::span<const Edge> EdgesOf(size_t strip) const;
  /// Whether hit(edge) for one of the edges near the segment.
  template <typename Hit>
  bool AnyNear(Point a, Point b, Hit hit) const;

  std::vector<Edge> edges_;  ///< as added; by strip once built
  std::vector<size_t> begins_;  ///< of strips, and one more
  Box box_;
  Coord height_ = 1;  ///< of a strip
};

}  // namespace slicefarm::ordering
