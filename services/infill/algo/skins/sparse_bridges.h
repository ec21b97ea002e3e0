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

/// Returns the middles of all bridges over cells of such a pitch that a solid part can hold: most hold none.
/// Cost: an offset.
MultiPolygon BridgeMiddles(const MultiPolygon& solid, double pitch_nm, Coord width_nm);

/// Returns the parts of the skins that lie over sparse infill and are wide enough to need bridges, whatever lines
/// are below. Cost: a boolean operation, and some where there are such parts.
MultiPolygon UnheldParts(const SparseBelow& below, Coord width_nm, const Skins& skins);

/// Takes `bridged` from the skins (UnheldParts). A cell that it touches is bridged as a whole, up
/// to a pitch away and onto the beads around it, so that lines end on beads: that comes from the
/// skins' sparse part. Invariant: the skins and the bridges tile what the skins did.
/// Cost: some boolean operations.
SparseBridges TakeSparseBridges(MultiPolygon bridged, const SparseBelow& below, Coord width_nm, Skins& skins);

}  // namespace slicefarm::infill
