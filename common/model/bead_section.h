#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "common/geometry/point.h"

namespace slicefarm {

// Cross section of a bead: a rectangle with semicircular ends (a stadium) of the given width and
// height. Neighbouring beads at a distance of `Spacing` fill the layer without voids: their
// overlap has the area that the round ends leave empty. Source: the flow model of Slic3r and
// PrusaSlicer.

/// Returns the centre distance of neighbouring beads of the same width: width - height (1 - pi/4).
Coord Spacing(Coord width_nm, Coord height_nm);

/// Checks that beads of this width have a positive spacing. Errors: SETTING_OUT_OF_RANGE for
/// `setting`, the name of the width's setting.
absl::Status CheckSpacing(std::string_view setting, Coord width_nm, Coord height_nm);

/// Returns the bead width that has the spacing `spacing_nm`.
Coord WidthForSpacing(Coord spacing_nm, Coord height_nm);

/// Returns the area of the bead's cross section in mm^2: height times spacing. A bead narrower than
/// its height has the cross section of a disc with its width as the diameter.
double SectionMm2(Coord width_nm, Coord height_nm);

/// Returns the width of the bead that fills a strip: its cross section is `strip_nm` times
/// `height_nm`. The result is WidthForSpacing(strip_nm). If that would be less than the height, the
/// result is the diameter of a disc with this area.
Coord WidthToFill(Coord strip_nm, Coord height_nm);

}  // namespace slicefarm
