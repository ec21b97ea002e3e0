#pragma once

#include "common/geometry/point.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

// Functions shared by the rows of regions that planning adds. All of them change the settings of
// the first region.

/// Sets one bead width for walls and infill.
void SetWidths(Coord width_nm, JobRows& settings);

/// Disables all options that make walls differ from a constant number of smooth walls: one wall on
/// the bed or on top, extra perimeters, fuzzy skin.
void MakePlain(BeadingOptions& beading);

/// Disables skins: the whole region is filled with lines of one density and one direction in all
/// layers. `density`: density of the lines, in [0, 1].
void FillAlike(double density, double angle_rad, InfillOptions& infill);

/// Returns the density of lines with gaps of `free_nm` between them; 0 fills a layer of this height
/// completely. PrusaSlicer calls this gap support_material_spacing.
double LineDensity(Coord width_nm, Coord height_nm, Coord free_nm);

}  // namespace slicefarm::config::fdm
