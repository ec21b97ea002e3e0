#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/beads/thick_line.h"

namespace slicefarm::beading {

struct MedialAxisOptions {
  Coord min_thickness_nm = 80'000;  ///< where the region is narrower there is no line
  Coord tolerance_nm = 5'000;       ///< of the lines' points and thicknesses
};

/// The middle lines of a narrow region: the part of its medial axis along which two sides face each
/// other. Branches into blunt corners are left out (there the width changes faster than a bead
/// can); ends reach towards the tips; where three lines meet the straighter two join to one, and
/// the third stops at its side.
///
/// Every circle around a point of a line, with its thickness as diameter, lies in the region to
/// within the tolerance. Regions that the Voronoi diagram cannot be trusted with (self-crossing by
/// rounding, or wider than 2.1 m) give no lines; a diagram is checked vertex by vertex before it is
/// used.
///
/// Cost: O(n log n), n points: a few us each.
/// Source: Voronoi diagram of segments by Boost.Polygon (Sweepline, Fortune); what is "facing" as
/// in T. Kuipers et al., "A Framework for Adaptive Width Control of Dense Contour-Parallel
/// Toolpaths in FDM", 2020, section 3.
std::vector<ThickLine> MedialAxis(const PolygonWithHoles& region, const MedialAxisOptions& options);

}  // namespace slicefarm::beading
