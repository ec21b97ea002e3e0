#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// A turn of a spiral: the only bead of a section, a loop along which the nozzle rises from the top
/// of the layer below to the top of its own.
struct SpiralTurn {
  Point start;                ///< of the loop, and its end
  std::optional<Point> from = {};  ///< where the turn below ends, and this one goes on; none: the first
  bool last = false;          ///< no turn follows
  bool blends = true;         ///< it leads over from the turn below all along, else at once

  friend bool operator==(const SpiralTurn&, const SpiralTurn&) = default;
};

/// The middle of a bead of `width_nm` along the inside of an outline; nothing where that is not one
/// loop: a hole, several islands, or a place too narrow for two beads.
std::optional<Polygon> SpiralLoop(const MultiPolygon& outline, Coord width_nm);

}  // namespace slicefarm
