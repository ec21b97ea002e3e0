#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// From the outline to the border of what rings or hatch fill. Rings run contour_distance from the
/// innermost contour; they keep half a distance from their border, less half of what those beside
/// a cut overlap. Hatch lines may run along the innermost contour as near as hatch_offset less
/// HatchTrim.
/// Hatch with `border_lines` (layer_shift.h) begins at the innermost of these.
Coord InsideInset(const ExposureOptions& options, int32_t border_lines = 0);

/// From the outline to each of the hatch's lines along the innermost contour, from outside in.
std::vector<Coord> BorderInsets(const ExposureOptions& options, int32_t border_lines);

/// How far hatch lines end before the border of what they fill, along the line: across the contour
/// they end hatch_offset from it. Lines that run along it would leave up to a distance open beside
/// it, had they to keep off as far.
Coord HatchTrim(const ExposureOptions& options);

/// What is nowhere this far from the outline is not filled like the rest: there contours leave open
/// only what middle lines melt (thin_walls.h), or nothing. 0: there is nothing of that kind.
Coord NarrowDepth(const ExposureOptions& options, int32_t border_lines = 0);

/// Two depths below the outline: what is melted so far, and where the next line wants to lie.
/// What lies deeper than the first, but nowhere as deep as the second, stays open.
struct LineLevel {
  Coord melted_nm = 0;
  Coord line_nm = 0;
};
/// From the outline inwards: the first contour, each that follows, the hatch's border lines or the
/// outermost ring. Hatch leaves nothing open beside the last of them. Only levels where something
/// may stay open.
std::vector<LineLevel> LineLevels(const ExposureOptions& options, int32_t border_lines = 0);

}  // namespace slicefarm::exposure
