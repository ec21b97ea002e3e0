#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"

namespace slicefarm::slicing {

/// A directed edge of an island: the material is on its left.
struct OutlineEdge {
  Point from, to;
  Vector2 along = Vector2::Zero();
  Vector2 inward = Vector2::Zero();
  Vector2 inward_before = Vector2::Zero();  ///< of the edges before and after it in the ring
  Vector2 inward_after = Vector2::Zero();
  bool reflex_from = false;  ///< the material's angle at that end is above 180 degrees
  bool reflex_to = false;
  int32_t next = 0;       ///< index of the edge after it in the ring
  double middle_rad = 0;  ///< of all its normals, those of its reflex ends included
  double half_rad = 0;    ///< no normal is farther than this from the middle
};

/// Cosines of the angle between two sides of the material from which on they count as opposite a
/// little, and wholly.
struct OppositeAngles {
  double begin_cos = 0;
  double full_cos = 0;
};
inline constexpr OppositeAngles kBelow60Degrees{0.5, 0.7071067811865476};  ///< wholly below 45
inline constexpr OppositeAngles kBelow90Degrees{0, 0.25881904510252074};   ///< wholly below 75

/// How wide an island is at points of its outlines, up to a limit.
class LocalWidth {
 public:
  /// REQUIRES: limit_nm > 0.
  LocalWidth(const PolygonWithHoles& island, Coord limit_nm, OppositeAngles angles);

  /// Ring by ring, in the rings' order; edges of no length are left out.
  const std::vector<OutlineEdge>& edges() const { return edges_; }

  Coord limit_nm() const { return limit_nm_; }

  /// Indices of the edges that may limit the width somewhere between two points of an edge, not
  /// farther apart than the limit. In ascending order. Cost: O(log n + those found).
  std::vector<int32_t> Opposite(const OutlineEdge& edge, Point from, Point to) const;

  /// The width at a point of `edge`, of the limit at most, where only the `opposite` edges matter:
  /// the diameter of the largest disc that touches the outline at p and one of them.
  double At(const OutlineEdge& edge, Point p, std::span<const int32_t> opposite) const;

 private:
  using Cell = std::pair<int64_t, int64_t>;
  Cell CellOf(double x, double y) const;
  template <typename Visit>
  void ForEachCell(Point from, Point to, Visit visit) const;

  Coord limit_nm_;
  OppositeAngles angles_;
  std::vector<OutlineEdge> edges_;
  std::vector<std::pair<Cell, int32_t>> cells_;  ///< sorted
};

}  // namespace slicefarm::slicing
