#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/ordering/algo/comb/barrier.h"
#include "services/ordering/algo/comb/edge_strips.h"

namespace slicefarm::ordering {

bool IsOuterWall(const Path& path);

/// The places of a way, its ends included.
std::vector<Point> PlacesOf(Point from, std::span<const Point> corners, Point to);

/// Half the mean width of the closed outer walls: how far inside the outline their middle lies. 0 if
/// there is none.
Coord OuterWallRadius(std::span<const Path> paths);

/// What a travel within an island had better not cross: the outline, and the middles of the outer
/// walls.
class IslandEdges : public Barrier {
 public:
  explicit IslandEdges(const FilledIsland& island);

  /// Whether ab leaves the island or crosses an outer wall. REQUIRES: a lies in the island.
  bool Parts(Point a, Point b) const override {
    return outline_.Meets(a, b) || walls_.Crosses(a, b);
  }
  /// Returns true if a way over these places, its ends apart, comes nearer than that to the middle
  /// of an outer wall. By default, so near that it might cross the wall as it is printed: motion
  /// simplifies paths by some micrometres. Cost: O(log walls) per place.
  bool Grazes(std::span<const Point> way, Coord near_nm = 30'000) const;
  bool Grazes(Point a, Point b) const { return Grazes(std::array{a, b}); }
  /// Whether p is inside the outline. REQUIRES: not on it.
  bool Surrounds(Point p) const { return outline_.Surrounds(p); }
  /// Whether there is an outline: nothing is known without.
  bool empty() const { return outline_.empty(); }

 private:
  EdgeStrips outline_;
  EdgeStrips walls_;
};

}  // namespace slicefarm::ordering
