#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// Cross section of a bead: a rectangle with semicircular ends (a stadium) of the given width and
/// height. Neighbouring beads at a distance of `Spacing` fill the layer without voids: their
/// overlap has the area that the round ends leave empty. Source: the flow model of Slic3r and
/// PrusaSlicer.

/// Returns the centre distance of neighbouring beads of the same width: width - height (1 - pi/4).
Coord Spacing(Coord width_nm, Coord height_nm);

/// Returns SETTING_OUT_OF_RANGE with the name of the width setting if the spacing would not be
/// positive.
absl::Status CheckSpacing(std::string_view setting, Coord width_nm, Coord height_nm);

/// Returns the bead width that has the spacing `spacing_nm`.
Coord WidthForSpacing(Coord spacing_nm, Coord height_nm);

/// Returns the section area in mm^2: height times spacing. A bead narrower than its height is a
/// disc of that width.
double SectionMm2(Coord width_nm, Coord height_nm);

/// Returns the width of the bead that fills a strip of width `strip_nm`: its section area is the
/// strip's width times the height. This is WidthForSpacing, or the diameter of a disc if that width
/// is below the height.
Coord WidthToFill(Coord strip_nm, Coord height_nm);

}  // namespace slicefarm
