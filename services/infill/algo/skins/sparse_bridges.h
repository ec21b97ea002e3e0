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

/// Returns true if a solid part may contain a bridge over cells of this pitch. This is a fast test,
/// because most parts contain none. Cost: an offset.
bool MayHoldBridges(const MultiPolygon& solid, double pitch_nm, Coord width_nm);

/// Removes the parts of the skins that are over sparse infill and have to be bridged: the solid
/// part there that is wide enough for a cell of the lines below. A cell that it touches is bridged
/// completely, up to a pitch away and onto the beads around it, so that lines end on beads. This
/// extension is removed from the skins' sparse part. Invariant: the skins and the bridges together
/// tile the area of the original skins. Cost: some boolean operations if there is a bridge,
/// otherwise one.
SparseBridges TakeSparseBridges(const SparseBelow& below, Coord width_nm, Skins& skins);

}  // namespace slicefarm::infill
