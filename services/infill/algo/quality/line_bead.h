#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::infill {

/// Bead of parallel lines: the width that gives their distance, and their plastic as a share of the
/// plastic that would fill the layer.
struct LineBead {
  Coord width_nm = 0;
  double share = 1;
};

/// Returns the bead of lines as high as the layer that cover the share `density` of their area,
/// with gaps between them. `flow`: factor on the lines' plastic. REQUIRES: density > 0.
LineBead SparseBead(Coord width_nm, Coord height_nm, double flow, double density);

/// Returns the bead of round strands as thick as the nozzle, with gaps between them, so that
/// strands that sag do not touch. REQUIRES: density > 0.
LineBead ThreadBead(Coord nozzle_nm, Coord height_nm, double flow, double density);

/// Gives beads of height `from_nm` the share `share` of their plastic, in a layer of height
/// `to_nm`.
void ScaleSections(double share, Coord from_nm, Coord to_nm, std::vector<Path>& paths);

}  // namespace slicefarm::infill
