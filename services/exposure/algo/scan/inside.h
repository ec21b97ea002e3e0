#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the distance from the outline to the boundary of the area that rings or hatch fill.
/// - Rings: the outermost ring is contour_distance from the innermost contour. Rings keep half a
///   hatch distance from the boundary of their area, less half of the overlap of rings beside a
///   cut.
/// - Hatch: lines may be as near to the innermost contour as hatch_offset less HatchTrim. With
///   `border_lines` (layer_shift.h), hatch begins at the innermost border line.
Coord InsideInset(const ExposureOptions& options, int32_t border_lines = 0);

/// Returns the distances from the outline to each of the `border_lines` hatch lines along the
/// innermost contour, from outside to inside.
std::vector<Coord> BorderInsets(const ExposureOptions& options, int32_t border_lines);

/// Returns the length by which hatch lines are shortened at the boundary of their area. A line that
/// meets the contour then ends hatch_offset from it. If the area were smaller instead, a line
/// parallel to the contour would also have to keep this distance, and could leave up to a hatch
/// distance unmelted.
Coord HatchTrim(const ExposureOptions& options);

/// Returns the depth that defines narrow parts: a part is narrow if no point of it is this far from
/// the outline. Hatch or rings do not fill narrow parts. In narrow parts, contours leave unmelted
/// only the area that middle lines melt (thin_walls.h), or nothing. 0: there are no narrow parts.
Coord NarrowDepth(const ExposureOptions& options, int32_t border_lines = 0);

/// Two distances from the outline, inwards in the layer. A part with its innermost point between
/// the two distances does not get the next line, so its middle stays unmelted.
struct LineLevel {
  Coord melted_nm = 0;  ///< distance up to which the area is melted already
  Coord line_nm = 0;    ///< distance of the next line
};
/// Returns the levels from the outline inwards: the first contour, each further contour, then the
/// hatch's border lines or the outermost ring. Hatch leaves nothing unmelted beside the last border
/// line. Only levels at which something may remain unmelted are returned.
std::vector<LineLevel> LineLevels(const ExposureOptions& options, int32_t border_lines = 0);

}  // namespace slicefarm::exposure
