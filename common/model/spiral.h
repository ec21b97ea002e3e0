#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Turn of a spiral, the only bead of a section. It is a loop along which the nozzle rises from the
/// top of the layer below to the top of the loop's own layer.
struct SpiralTurn {
  Point start;  ///< start and end of the loop
  /// End of the turn below, from which this turn continues; none: the first turn.
  std::optional<Point> from = {};
  bool last = false;  ///< true if no turn follows
  /// True: the path moves gradually from the turn below to this one; false: at once.
  bool blends = true;

  friend bool operator==(const SpiralTurn&, const SpiralTurn&) = default;
};

/// Returns the centre line of a bead of `width_nm` along the inside of an outline. Returns nullopt
/// if the result is not a single loop: the outline has a hole or several islands, or is narrower
/// than two beads.
std::optional<Polygon> SpiralLoop(const MultiPolygon& outline, Coord width_nm);

}  // namespace slicefarm
