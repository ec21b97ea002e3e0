#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the distance from the outline to the boundary of the area that rings or hatch fill.
/// - Rings: the outermost ring is contour_distance from the innermost contour. It is half a hatch
///   distance, less half of ring_overlap, inside the boundary of the area.
/// - Hatch: lines may be as near to the innermost contour as hatch_offset less HatchTrim. With
///   `border_lines` (layer_shift.h), hatch begins at the innermost border line.
Coord InsideInset(const ExposureOptions& options, int32_t border_lines = 0);

/// Returns the distances from the outline to each of the `border_lines` hatch lines along the
/// innermost contour, from outside to inside.
std::vector<Coord> BorderInsets(const ExposureOptions& options, int32_t border_lines);

/// Returns the length by which hatch lines are shortened at the boundary of their area. A line that
/// meets the contour at right angles then ends hatch_offset from it. The alternative would be a
/// smaller area. Then a line parallel to the contour would have to keep the same distance, and
/// could leave a strip of up to a hatch distance unmelted.
Coord HatchTrim(const ExposureOptions& options);

/// Returns the depth that defines narrow parts: a part is narrow if no point of it is this far from
/// the outline. Hatch or rings do not fill narrow parts. There, middle lines (thin_walls.h) melt
/// the area that contours leave unmelted. 0: there are no narrow parts.
Coord NarrowDepth(const ExposureOptions& options, int32_t border_lines = 0);

/// Two distances inwards from the outline, for one line that follows the outline (contour, border
/// line or ring). If a part's innermost point is between the two distances, the part is too thin
/// for this line. Its middle then stays unmelted.
struct LineLevel {
  Coord melted_nm = 0;  ///< distance up to which the area is melted already
  Coord line_nm = 0;    ///< distance of the next line
};
/// Returns the levels from the outline inwards: the first contour, each further contour, then the
/// hatch's border lines or the outermost ring. There is no level inside the last border line,
/// because hatch leaves nothing unmelted beside it. Levels at which nothing can remain unmelted are
/// left out.
std::vector<LineLevel> LineLevels(const ExposureOptions& options, int32_t border_lines = 0);

}  // namespace slicefarm::exposure
