#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"

namespace slicefarm::slicing {

/// Directed edge of an island, with the material on its left.
struct OutlineEdge {
  Point from, to;
  Vector2 along = Vector2::Zero();
  Vector2 inward = Vector2::Zero();
  Vector2 inward_before = Vector2::Zero();  ///< inward normal of the previous edge in the ring
  Vector2 inward_after = Vector2::Zero();
  bool reflex_from = false;  ///< true if the material's angle at `from` is above 180 degrees
  bool reflex_to = false;
  int32_t next = 0;  ///< index of the next edge in the ring
  /// middle, as an angle, of the range of the edge's normals; the range includes normals at reflex
  /// ends
  double middle_rad = 0;
  double half_rad = 0;  ///< half of this range: largest angle between a normal and the middle
};

/// Limits for the angle between two sides of the material, as cosines. Below the first angle they
/// begin to count as opposite; below the second they count fully.
struct OppositeAngles {
  double begin_cos = 0;
  double full_cos = 0;
};
/// Begin to count below 60 degrees, count fully below 45 degrees.
inline constexpr OppositeAngles kBelow60Degrees{0.5, 0.7071067811865476};
/// Begin to count below 90 degrees, count fully below 75 degrees.
inline constexpr OppositeAngles kBelow90Degrees{0, 0.25881904510252074};

/// Width of an island at points of its outlines, up to a limit.
class LocalWidth {
 public:
  /// REQUIRES: limit_nm > 0.
  LocalWidth(const PolygonWithHoles& island, Coord limit_nm, OppositeAngles angles);

  /// Returns the edges ring by ring, in the order of the rings, without edges of zero length.
  const std::vector<OutlineEdge>& edges() const { return edges_; }

  /// Returns the limit: larger widths are reported as this value.
  Coord limit_nm() const { return limit_nm_; }

  /// Returns the ascending indices of the edges that may limit the width between two points of
  /// `edge`. REQUIRES: the points are at most the limit apart. Cost: O(log n + number of edges
  /// found).
  std::vector<int32_t> Opposite(const OutlineEdge& edge, Point from, Point to) const;

  /// Returns the width at a point of `edge`, at most the limit: the diameter of the largest disc
  /// that touches the outline at p and one of the `opposite` edges. Other edges are ignored.
  double At(const OutlineEdge& edge, Point p, std::span<const int32_t> opposite) const;

 private:
  using Cell = std::pair<int64_t, int64_t>;
  Cell CellOf(double x, double y) const;
  template <typename Visit>
  void ForEachCell(Point from, Point to, Visit visit) const;

  Coord limit_nm_;
  OppositeAngles angles_;
  std::vector<OutlineEdge> edges_;
  /// pairs of a grid cell and the index of an edge in it, sorted
  std::vector<std::pair<Cell, int32_t>> cells_;
};

}  // namespace slicefarm::slicing
