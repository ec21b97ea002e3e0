#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/edge_index.h"
#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"
#include "services/motion/algo/toolpath/path_segment.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Outlines of the layer below a layer's beads.
class LayerBelow {
 public:
  /// `outlines`: disjoint polygons. Cost: O(edges + squares).
  explicit LayerBelow(const MultiPolygon& outlines);

  /// Returns the share of a bead's width that is supported by the outlines, at a point of its
  /// centre line. The share is 1 at half a width inside the outlines, 0.5 on them, and 0 at half a
  /// width outside. Cost: O(edges beside the point).
  double RestOf(Point point, Coord width_nm) const;

  /// Returns true if the point is within the outlines. Cost: O(edges beside the point).
  bool Covers(Point point) const;

  /// Returns the positions where a line crosses the outlines, as ascending shares of its length.
  /// Cost: O(edges beside the line).
  std::vector<double> EdgesOn(Point from, Point to) const;

 private:
  using Edge = EdgeIndex::Edge;
  Vector2 MiddleOf(int32_t row, int32_t column) const;
  void FindMiddlesInside();

  EdgeIndex edges_;
  int32_t columns_ = 0;
  std::vector<bool> middle_inside_;  ///< true for squares with their middle within the outlines
};

/// Piece of a segment with one supported share (`rest`).
struct RestingPiece {
  size_t segment = 0;
  Point to;
  uint8_t rest = kFullRest;
};

/// Resolution of the supported share (`rest`) of beads.
enum class RestSteps {
  kAll,
  kAirAlone,  ///< only two values: completely in the air, or completely supported
};

/// Divides the segments of a wall into pieces of at most about 1 mm.
///
/// Consecutive pieces with supported shares that differ by at most 5 % of the width get one common
/// share, the middle of their range. So the speed of an evenly overhanging wall does not flicker
/// where the chords of a curve are above the chords of another one. A share of 0 or of 1 is never
/// averaged. Cost: one query of the layer below at each end of a piece.
std::vector<RestingPiece> PiecesOver(const LayerBelow& below, RestSteps steps,
                                     std::span<const PathSegment> segments);

/// Interpolates a value for the supported share `rest`, in percent. `told`: values at 0, 25, 50 and
/// 75 %. `full`: value at 100 %.
double ByRest(const std::array<double, kOverhangDegrees>& told, double full, uint8_t rest);

}  // namespace slicefarm::motion
