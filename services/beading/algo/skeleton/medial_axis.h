#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/beads/thick_line.h"

namespace slicefarm::beading {

/// Options for MedialAxis.
struct MedialAxisOptions {
  Coord min_thickness_nm = 80'000;  ///< a line ends where the region is narrower than this
  Coord tolerance_nm = 5'000;       ///< tolerance of the lines' points and thicknesses
};

/// Returns the middle lines of a narrow region: the part of its medial axis along which two sides
/// of the outline face each other. Branches into blunt corners are omitted, because the width
/// changes there faster than a bead can. Ends are extended towards the region's tips. If three
/// lines meet, the straightest pair forms one line, and the third line ends at the side of this
/// line's bead.
///
/// A circle around a point of a line, with the point's thickness as diameter, exceeds the region by
/// at most the tolerance. The result is empty if the axis is unreliable (rings that cross by
/// rounding) or if the region is wider than 2.1 m.
///
/// Cost: O(n log n) for n points: a few us each. Source: MakeSkeletalGraph. "Facing" is defined as
/// in T. Kuipers et al., "A Framework for Adaptive Width Control of Dense Contour-Parallel
/// Toolpaths in FDM", 2020, section 3.
std::vector<ThickLine> MedialAxis(const PolygonWithHoles& region, const MedialAxisOptions& options);

}  // namespace slicefarm::beading
