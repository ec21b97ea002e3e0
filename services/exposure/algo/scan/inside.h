#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the distance from the outline to the border of the area that rings or hatch fill. Rings
/// run contour_distance from the innermost contour. They keep half a hatch distance from the border
/// of their area, less half of the overlap of rings beside a cut. Hatch lines may run as near to
/// the innermost contour as hatch_offset less HatchTrim. Hatch with `border_lines` (layer_shift.h)
/// begins at the innermost border line.
Coord InsideInset(const ExposureOptions& options, int32_t border_lines = 0);

/// Returns the distances from the outline to each of the hatch's lines along the innermost contour,
/// from outside to inside.
std::vector<Coord> BorderInsets(const ExposureOptions& options, int32_t border_lines);

/// Returns the distance along the line at which hatch lines end before the border of their area. A
/// line that meets the contour ends hatch_offset from it. Without the trim, a line parallel to the
/// contour would have to keep this distance too, and could leave up to a hatch distance open.
Coord HatchTrim(const ExposureOptions& options);

/// Returns the depth that defines narrow parts. A part that is nowhere this far from the outline is
/// not filled normally. There contours leave open only the area that middle lines melt
/// (thin_walls.h), or nothing. 0: there are no narrow parts.
Coord NarrowDepth(const ExposureOptions& options, int32_t border_lines = 0);

/// Two depths below the outline: the melted depth, and the depth of the next line. A part that is
/// deeper than the first depth, but nowhere as deep as the second, remains open.
struct LineLevel {
  Coord melted_nm = 0;
  Coord line_nm = 0;
};
/// Returns the levels from the outline inwards: the first contour, each further contour, then the
/// hatch's border lines or the outermost ring. Hatch leaves nothing open beside the last border
/// line. Only levels at which something may remain open are returned.
std::vector<LineLevel> LineLevels(const ExposureOptions& options, int32_t border_lines = 0);

}  // namespace slicefarm::exposure
