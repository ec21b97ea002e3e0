#pragma once

#include "common/geometry/point.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

// What rows of regions that planning adds have in common; all change the first region's settings.

/// Beads of one width in place of what the part's walls and infill have.
void SetWidths(Coord width_nm, JobRows& settings);

/// Nothing but the number of walls that is asked for.
void MakePlain(BeadingOptions& beading);

/// No skins: all of a region is filled alike, with lines that do not turn from layer to layer.
void FillAlike(double density, double angle_rad, InfillOptions& infill);

/// The density of lines that lie `free_nm` further apart than lines that fill a layer of that height:
/// what PrusaSlicer calls support_material_spacing.
double LineDensity(Coord width_nm, Coord height_nm, Coord free_nm);

}  // namespace slicefarm::config::fdm
