#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Turn of a spiral: a loop along which the nozzle rises from the top of the layer below to the top
/// of the loop's own layer. The turn is the only bead of its section.
struct SpiralTurn {
  Point start;  ///< start and end of the loop
  /// End of the turn in the layer below, from which this turn continues; nullopt for the first
  /// turn.
  std::optional<Point> from = {};
  bool last = false;  ///< true if no turn follows
  /// True: the path changes gradually from the turn below to this one. False: the path follows this
  /// turn from its start.
  bool blends = true;

  friend bool operator==(const SpiralTurn&, const SpiralTurn&) = default;
};

/// Returns the centre line of a bead of `width_nm` along the inside of an outline. Returns nullopt
/// if the result is not a single loop: the outline has a hole or several islands, or is narrower
/// than two beads.
std::optional<Polygon> SpiralLoop(const MultiPolygon& outline, Coord width_nm);

}  // namespace slicefarm
