#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm::infill {

/// The sparse infill of the layer below a fill area, as far as outlines tell.
struct SparseBelow {
  MultiPolygon region;  ///< where it lies, within the fill area
  MultiPolygon beads;   ///< its lines, as wide as they are; empty: where they lie is not known
  double pitch_nm = 0;  ///< of its lines
};

/// Bridges over sparse infill.
struct SparseBridges {
  MultiPolygon regions;
  MultiPolygon bearers;  ///< what their lines may lie on: the beads below, and what is solid there
};

/// Whether a solid part may hold a bridge over cells of such a pitch: a quick look, for most do not.
/// Cost: an offset.
bool MayHoldBridges(const MultiPolygon& solid, double pitch_nm, Coord width_nm);

/// Takes from the skins what lies over sparse infill and has to be bridged: the solid part there that
/// is wide enough to hold a cell of the lines below. A cell that it touches is bridged as a whole, up
/// to a pitch away and onto the beads around it, so that lines end on beads: that comes from the
/// skins' sparse part. Invariant: the skins and the bridges tile what the skins did.
/// Cost: some boolean operations where there is something to bridge, else one.
SparseBridges TakeSparseBridges(const SparseBelow& below, Coord width_nm, Skins& skins);

}  // namespace slicefarm::infill
