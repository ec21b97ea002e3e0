#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm::infill {

/// Sparse infill of the layer below a fill area, as far as outlines define it.
struct SparseBelow {
  MultiPolygon region;  ///< area of the sparse infill within the fill area
  MultiPolygon beads;   ///< area of its beads; empty: the lines' positions are unknown
  double pitch_nm = 0;  ///< pitch of its lines
};

/// Bridges over sparse infill.
struct SparseBridges {
  MultiPolygon regions;
  MultiPolygon bearers;  ///< supports of their lines: the beads below, and the solid areas there
};

/// Returns the centres of all bridges over cells of this pitch that fit into a solid part. Most
/// parts have none. Cost: one offset.
MultiPolygon BridgeMiddles(const MultiPolygon& solid, double pitch_nm, Coord width_nm);

/// Returns the parts of the skins over sparse infill that are wide enough to need bridges,
/// independently of the lines below. Cost: one boolean operation, and a few more per part found.
MultiPolygon UnheldParts(const SparseBelow& below, Coord width_nm, const Skins& skins);

/// Takes `bridged` (the result of UnheldParts) from the skins. A cell that it touches is bridged as
/// a whole, up to one pitch away and onto the beads around it, so that lines end on beads. This
/// area is taken from the sparse part of the skins. Invariant: the skins and the bridges together
/// cover the area that the skins covered before. Cost: a few boolean operations.
SparseBridges TakeSparseBridges(MultiPolygon bridged, const SparseBelow& below, Coord width_nm,
                                Skins& skins);

}  // namespace slicefarm::infill
