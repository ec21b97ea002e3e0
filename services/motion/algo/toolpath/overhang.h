#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/geometry/edge_index.h"
#include "common/geometry/polygon.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// What lies below a layer's beads.
class LayerBelow {
 public:
  /// `outlines`: disjoint polygons. Cost: O(edges + squares).
  explicit LayerBelow(const MultiPolygon& outlines);

  /// The share of a bead of `width_nm` around a point of its middle that rests: all of it half a
  /// width within the outlines, half on them, nothing half a width outside. Cost: O(edges beside
  /// the point).
  uint8_t RestOf(Point point, Coord width_nm) const;

  /// Whether the point lies within the outlines. Cost: O(edges beside the point).
  bool Covers(Point point) const;

  /// Where a line from point to point meets edges, as shares of its length, upwards. Cost: O(edges
  /// beside the line).
  std::vector<double> EdgesOn(Point from, Point to) const;

 private:
  using Edge = EdgeIndex::Edge;
  struct Middle {
    double x = 0, y = 0;
  };

  Middle MiddleOf(int32_t row, int32_t column) const;
  void FindMiddlesInside();

  EdgeIndex edges_;
  int32_t columns_ = 0;
  std::vector<bool> middle_inside_;  ///< by square: whether its middle lies within the outlines
};

/// A piece of a straight bead that rests alike.
struct RestingPiece {
  Point to;
  uint8_t rest = kFullRest;
};

/// What is told apart of how beads rest.
enum class RestSteps {
  kAll,
  kAirAlone,  ///< nothing rests, or all of it is taken to
};

/// Looks below the beads of a wall, each of which begins where the one before ends: once at a
/// point.
class RestAlong {
 public:
  /// `below` must outlive this.
  RestAlong(const LayerBelow& below, RestSteps steps) : below_(below), steps_(steps) {}

  /// A bead from point to point in pieces of at least about 1 mm, or as long as the bead.
  std::vector<RestingPiece> PiecesOf(Point from, Point to, Coord width_nm);

 private:
  int RestOf(Point point, Coord width_nm);

  const LayerBelow& below_;
  const RestSteps steps_;
  Point at_;
  Coord width_nm_ = -1;  ///< none: no point was looked at
  int rest_ = 0;
};

/// A value that is told for rests of 0, 25, 50 and 75 %, in between and up to `full` at 100 % in
/// proportion.
double ByRest(const std::array<double, kOverhangDegrees>& told, double full, uint8_t rest);

}  // namespace slicefarm::motion
