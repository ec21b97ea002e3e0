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

/// What lies below a layer's beads.
class LayerBelow {
 public:
  /// `outlines`: disjoint polygons. Cost: O(edges + squares).
  explicit LayerBelow(const MultiPolygon& outlines);

  /// The share of a bead of `width_nm` around a point of its middle that rests: 1 half a width
  /// within the outlines, 0.5 on them, 0 half a width outside. Cost: O(edges beside the point).
  double RestOf(Point point, Coord width_nm) const;

  /// Whether the point lies within the outlines. Cost: O(edges beside the point).
  bool Covers(Point point) const;

  /// Where a line from point to point meets edges, as shares of its length, upwards. Cost: O(edges
  /// beside the line).
  std::vector<double> EdgesOn(Point from, Point to) const;

 private:
  using Edge = EdgeIndex::Edge;
  Vector2 MiddleOf(int32_t row, int32_t column) const;
  void FindMiddlesInside();

  EdgeIndex edges_;
  int32_t columns_ = 0;
  std::vector<bool> middle_inside_;  ///< by square: whether its middle lies within the outlines
};

/// A piece of a segment that rests alike.
struct RestingPiece {
  size_t segment = 0;
  Point to;
  uint8_t rest = kFullRest;
};

/// What is told apart of how beads rest.
enum class RestSteps {
  kAll,
  kAirAlone,  ///< nothing rests, or all of it is taken to
};

/// The segments of a wall in pieces of at least about 1 mm, or as long as the segment.
/// Pieces that follow each other and rest alike within 5 % of the width have one rest, midway:
/// along a wall that hangs over evenly, chords of a curve on chords of another one do not make the
/// speed flicker. Nothing and all of it are told by themselves. Cost: one look below at each end.
std::vector<RestingPiece> PiecesOver(const LayerBelow& below, RestSteps steps,
                                     std::span<const PathSegment> segments);

/// A value that is told for rests of 0, 25, 50 and 75 %, in between and up to `full` at 100 % in
/// proportion.
double ByRest(const std::array<double, kOverhangDegrees>& told, double full, uint8_t rest);

}  // namespace slicefarm::motion
