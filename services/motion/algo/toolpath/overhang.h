#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/edge_index.h"
#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"
#include "common/model/options/region_motion.h"
#include "services/motion/algo/toolpath/path_segment.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Area covered by the layer below, for queries about the beads of a layer.
class LayerBelow {
 public:
  /// `outlines`: disjoint polygons of the layer below. Cost: O(edges + squares of a grid).
  explicit LayerBelow(const MultiPolygon& outlines);

  /// Returns the share of a bead's width that the layer below supports, at a point of the bead's
  /// centre line. The share is 1 if the point is half a width inside the outlines, 0.5 on an
  /// outline, and 0 at half a width outside. Cost: O(edges near the point).
  double RestOf(Point point, Coord width_nm) const;

  /// Returns true if the point is within the outlines. Cost: O(edges beside the point).
  bool Covers(Point point) const;

  /// Returns the crossings of the line with the outlines, ascending. Each crossing is given as a
  /// share of the line's length, from 0 at `from` to 1 at `to`. Cost: O(edges near the line).
  std::vector<double> EdgesOn(Point from, Point to) const;

 private:
  using Edge = EdgeIndex::Edge;
  Vector2 MiddleOf(int32_t row, int32_t column) const;
  void FindMiddlesInside();

  EdgeIndex edges_;
  int32_t columns_ = 0;
  /// true for grid squares with their middle within the outlines; indexed by square
  std::vector<bool> middle_inside_;
};

/// Piece of a segment with one supported share (`rest`, in percent). It ends at `to`.
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
/// Consecutive pieces get one common share if their supported shares differ by at most 5 % of the
/// width. The common share is the middle of the range of these shares. Without this, the speed of
/// an evenly overhanging wall would flicker, because the chords of its curve are not exactly above
/// the chords of the curve below. A share of 0 or of 1 is never averaged. Cost: one query of the
/// layer below at each end of a piece.
std::vector<RestingPiece> PiecesOver(const LayerBelow& below, RestSteps steps,
                                     std::span<const PathSegment> segments);

/// Interpolates a value for the supported share `rest`, in percent. `values`: values for the
/// shares 0, 25, 50 and 75 %. `full`: value for 100 %.
double ByRest(const std::array<double, kOverhangDegrees>& values, double full, uint8_t rest);

}  // namespace slicefarm::motion
