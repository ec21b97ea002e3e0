#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// The section of a bead: a rectangle with round ends (a stadium), `width` over all, `height`
/// thick. Beads that lie `Spacing` apart tile: what the round ends lack, the overlap gives. Source:
/// the flow model of Slic3r and PrusaSlicer.

/// Distance of neighbours of the same width: width - height (1 - pi/4).
Coord Spacing(Coord width_nm, Coord height_nm);

/// SETTING_OUT_OF_RANGE that names the setting of the width, if neighbours would not lie apart.
absl::Status CheckSpacing(std::string_view setting, Coord width_nm, Coord height_nm);

/// The width whose spacing is `spacing_nm`.
Coord WidthForSpacing(Coord spacing_nm, Coord height_nm);

/// Section area in mm^2: height times spacing. For a width below the height, a disc of that width.
double SectionMm2(Coord width_nm, Coord height_nm);

/// The width of the bead whose section is `strip_nm` times the height, so that it fills a strip of
/// that width: WidthForSpacing, and a disc's diameter where that comes below the height.
Coord WidthToFill(Coord strip_nm, Coord height_nm);

}  // namespace slicefarm
