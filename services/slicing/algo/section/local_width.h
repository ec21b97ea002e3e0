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
  /// middle direction of all normals of the edge, including the normals at its reflex ends
  double middle_rad = 0;
  double half_rad = 0;  ///< largest angle between a normal of the edge and the middle direction
};

/// Two sides of the material count as opposite if the angle between them is small. Cosine of the
/// angle below which they begin to count, and of the angle below which they count fully.
struct OppositeAngles {
  double begin_cos = 0;
  double full_cos = 0;
};
/// Angles of 60 degrees (begin to count) and 45 degrees (count fully).
inline constexpr OppositeAngles kBelow60Degrees{0.5, 0.7071067811865476};
/// Angles of 90 degrees (begin to count) and 75 degrees (count fully).
inline constexpr OppositeAngles kBelow90Degrees{0, 0.25881904510252074};

/// Width of an island at points of its outlines, up to a limit.
class LocalWidth {
 public:
  /// REQUIRES: limit_nm > 0.
  LocalWidth(const PolygonWithHoles& island, Coord limit_nm, OppositeAngles angles);

  /// Returns the edges ring by ring, in the order of the rings, without edges of zero length.
  const std::vector<OutlineEdge>& edges() const { return edges_; }

  /// Returns the largest width that is measured.
  Coord limit_nm() const { return limit_nm_; }

  /// Returns the indices of the edges that may limit the width somewhere between two points of an
  /// edge. The points are at most the limit apart. The indices ascend. Cost: O(log n + number of
  /// edges found).
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
  std::vector<std::pair<Cell, int32_t>> cells_;  ///< cell and index of an edge in it, sorted
};

}  // namespace slicefarm::slicing
