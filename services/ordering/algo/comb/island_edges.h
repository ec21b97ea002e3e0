#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/ordering/algo/comb/barrier.h"
#include "services/ordering/algo/comb/edge_strips.h"

namespace slicefarm::ordering {

/// Returns true if the path is part of an outer wall.
bool IsOuterWall(const Path& path);

/// Returns the points of a travel, including its ends.
std::vector<Point> PointsOf(Point from, std::span<const Point> corners, Point to);

/// Returns half the mean width of the closed outer walls: the distance from the outline to their
/// centre line. Returns 0 if there is no closed outer wall.
Coord OuterWallRadius(std::span<const Path> paths);

/// Obstacles for travels within an island: the outline and the centre lines of the outer walls.
class IslandEdges : public Barrier {
 public:
  /// Collects the outline and the outer walls of the island.
  explicit IslandEdges(const FilledIsland& island);

  /// Returns true if ab leaves the island or crosses an outer wall. A wall within a micrometre of
  /// an end is not crossed: a loop may start inside an edge, and the start is rounded to one side
  /// of the edge. REQUIRES: a is in the island.
  bool Parts(Point a, Point b) const override;
  /// Returns true if a travel over these points, except near its ends, is closer than `near_nm` to
  /// the centre line of an outer wall. At the default distance the travel might cross the printed
  /// wall, because the motion service moves simplified paths by some micrometres. Cost: O(log
  /// walls) per point.
  bool Grazes(std::span<const Point> route, Coord near_nm = 30'000) const;
  bool Grazes(Point a, Point b) const { return Grazes(std::array{a, b}); }
  /// Returns true if p is inside the outline. REQUIRES: p is not on the outline.
  bool Surrounds(Point p) const { return outline_.Surrounds(p); }
  /// Returns true if there is no outline. In this case, do not use Parts, Grazes and Surrounds.
  bool empty() const { return outline_.empty(); }

 private:
  EdgeStrips outline_;
  EdgeStrips walls_;
};

}  // namespace slicefarm::ordering
