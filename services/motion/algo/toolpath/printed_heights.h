#pragma once

#include <cstdint>
#include <unordered_map>

#include "common/geometry/point.h"

namespace slicefarm::motion {

/// Heights of the beads that are already printed in a layer, on a grid. They decide how low the
/// nozzle may go: its flat tip and its cone must not touch higher beads.
class PrintedHeights {
 public:
  /// `tip_nm`: radius of the nozzle's flat tip. Above the tip the nozzle widens by 45 degrees.
  /// The squares of the grid grow with wide tips.
  explicit PrintedHeights(Coord tip_nm);

  /// Adds a point of a bead. `up_nm`: height of the bead above the layer's top, at most 0.
  void Add(Point point, Coord up_nm);

  /// Returns the lowest height above the layer's top, at most 0, at which the nozzle at `point`
  /// touches no printed bead; `lowest_nm` (below 0) if there is none near. Cost: O(1), the grid
  /// squares within the tip's radius and -`lowest_nm`: about 100 for nozzles of any size.
  Coord LeastUp(Point point, Coord lowest_nm) const;

 private:
  Coord IndexOf(Coord nm) const;
  Point MiddleOf(Coord column, Coord row) const;

  Coord tip_nm_;
  Coord side_nm_;                              ///< side of a grid square
  std::unordered_map<uint64_t, Coord> up_nm_;  ///< highest bead of each square
};

}  // namespace slicefarm::motion
