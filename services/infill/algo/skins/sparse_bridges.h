#pragma once

#include <optional>

#include "common/geometry/polygon.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm::infill {

/// Sparse infill of the layer below a fill area, computed from the outlines of layers.
struct SparseBelow {
  MultiPolygon region;  ///< part of the fill area that has sparse infill below it
  /// area of the infill's beads; empty if the positions of its lines are not known
  MultiPolygon beads;
  double pitch_nm = 0;      ///< distance between lines of the infill, or between groups of lines
  double least_gap_nm = 0;  ///< least width of a skin to be bridged, besides its own line, in nm
};

/// Bridges over sparse infill.
struct SparseBridges {
  MultiPolygon regions;
  /// Areas that support the bridges' lines: the beads below, and the solid areas around.
  MultiPolygon bearers;
};

/// Returns the points of `solid` around which it is wide enough for a bridge over gaps of
/// `gap_nm`, with beads of `width_nm`. For most solid parts the result is empty. Cost: one offset.
MultiPolygon BridgeMiddles(const MultiPolygon& solid, double gap_nm, Coord width_nm);

/// Returns the parts of `skins.solid` over sparse infill that need bridges: the parts that are at
/// least below.least_gap_nm + `width_nm` wide. The positions of the lines below are not used. Cost:
/// one intersection; a few offsets and one intersection more for the parts found.
MultiPolygon UnheldParts(const SparseBelow& below, Coord width_nm, const Skins& skins);

/// Removes `bridged` (the result of UnheldParts) from the skins and returns it as bridges. If the
/// beads below are known, `bridged` first grows by at most one pitch. It then covers whole cells
/// between beads and the beads around these cells, so that lines end on beads. The added area is
/// removed from the solid and the sparse part of the skins. Invariant: the skins and the bridges
/// together cover the area that the skins covered before. Cost: a few boolean operations.
SparseBridges TakeSparseBridges(MultiPolygon bridged, const SparseBelow& below, Coord width_nm,
                                Skins& skins);

}  // namespace slicefarm::infill
