#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm::infill {

/// Sparse infill of the layer below a fill area, as far as the outlines of layers determine it.
struct SparseBelow {
  MultiPolygon region;  ///< part of the fill area that has sparse infill below it
  MultiPolygon beads;   ///< area of the infill's beads; empty: the lines' positions are unknown
  double pitch_nm = 0;  ///< pitch of the infill's lines
};

/// Bridges over sparse infill.
struct SparseBridges {
  MultiPolygon regions;
  /// Supports of the bridges' lines: the beads below, and the solid areas around.
  MultiPolygon bearers;
};

/// Returns the points of `solid` around which it is wide enough for a bridge over infill of this
/// pitch, with beads of `width_nm`. Most solid parts have none. Cost: one offset.
MultiPolygon BridgeMiddles(const MultiPolygon& solid, double pitch_nm, Coord width_nm);

/// Returns the parts of `skins.solid` over sparse infill that need bridges: they are wider than the
/// pitch plus one bead. The positions of the lines below do not matter. Cost: one boolean
/// operation, and a few more per part found.
MultiPolygon UnheldParts(const SparseBelow& below, Coord width_nm, const Skins& skins);

/// Removes `bridged` (the result of UnheldParts) from the skins and returns it as bridges. If the
/// beads below are known, `bridged` first grows by at most one pitch: to whole cells between beads,
/// and onto the beads around them, so that lines end on beads. The added area is removed from the
/// solid and the sparse part of the skins. Invariant: the skins and the bridges together cover the
/// area that the skins covered before. Cost: a few boolean operations.
SparseBridges TakeSparseBridges(MultiPolygon bridged, const SparseBelow& below, Coord width_nm,
                                Skins& skins);

}  // namespace slicefarm::infill
