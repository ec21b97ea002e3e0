#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::ordering {

/// Edges of rings and lines, indexed by horizontal strips. Finds the edges that a segment crosses,
/// and whether a point is inside the rings. Results are exact.
///
/// Each strip lists the edges that reach into it, sorted by their left ends. A strip is as high as
/// an average edge, so that all strips together have at most about three entries per edge. Cost:
/// O(n log n) to build, n edges. A query visits the strips of the segment, and in each strip the
/// edges left of the segment's right end there.
class EdgeStrips {
 public:
  static constexpr uint32_t kAll = std::numeric_limits<uint32_t>::max();

  /// Adds the edges of a ring. `order`: their rank, which Crosses compares. Add all rings and
  /// lines, then call Build; queries are valid only after Build.
  void AddRing(std::span<const Point> ring, uint32_t order = 0);
  /// Adds the edges of an open line. `order`: their rank, which Crosses compares.
  void AddLine(std::span<const Point> line, uint32_t order = 0);
  /// Sorts the added edges into strips.
  void Build();

  bool empty() const { return edges_.empty(); }

  /// Returns true if the segment ab shares a point with an edge.
  bool Meets(Point a, Point b) const;
  /// Returns true if ab crosses an edge with an `order` less than `before`. The crossing must be an
  /// inner point of both; a common end is no crossing.
  bool Crosses(Point a, Point b, uint32_t before = kAll) const;
  /// Returns true if p is inside an odd number of the rings. REQUIRES: p is not on a ring.
  bool Surrounds(Point p) const;

 private:
  struct Edge {
    Point low, high;  ///< ends of the edge, sorted by y
    uint32_t order;

    Coord left() const { return low.x < high.x ? low.x : high.x; }
    Coord right() const { return low.x < high.x ? high.x : low.x; }
  };

  void Add(Point a, Point b, uint32_t order);
  size_t StripOf(Coord y) const;
  std::span<const Edge> EdgesOf(size_t strip) const;
  /// Returns true if hit(edge) is true for at least one edge near the segment ab.
  template <typename Hit>
  bool AnyNear(Point a, Point b, Hit hit) const;

  std::vector<Edge> edges_;  ///< edges in the order of adding; after Build, grouped by strip
  /// Index in `edges_` of each strip's first edge; one more entry than strips.
  std::vector<size_t> begins_;
  Box box_;
  Coord height_ = 1;  ///< height of a strip, in nm
};

}  // namespace slicefarm::ordering
