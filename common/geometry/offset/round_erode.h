#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Shrinks an island to the points at least `distance_nm` away from its outline. It may split or
/// lose parts. Around reflex corners the result has arcs; their chords are at most
/// `arc_tolerance_nm` beyond them. Returns nullopt if the swept curve is not in general position.
/// REQUIRES: distance_nm > 0; the island is simple. Cost: that of TryErode.
std::optional<MultiPolygon> TryRoundErode(const PolygonWithHoles& island, Coord distance_nm,
                                          Coord arc_tolerance_nm);

/// Answer of JudgeWidth.
enum class Width {
  kWide,
  kNarrow,
  kUncertain,  ///< the swept curve is not in general position
};

/// Judges if discs of `radius_nm` reach everything in an island except for its convex corners.
/// "Wide": each ring of the outline, eroded by the radius, is one ring. Parts of the outline that
/// have no part in the erosion are convex corners: any two of their edges, and the edges beside
/// them, turn by less than `most_turn` radians. So nowhere do two sides within twice the radius
/// face each other at less than pi - most_turn.
///
/// REQUIRES: as TryRoundErode. Cost: that of TryErode.
Width JudgeWidth(const PolygonWithHoles& island, Coord radius_nm, double most_turn);

}  // namespace slicefarm
