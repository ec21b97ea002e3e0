#pragma once

#include "services/exposure/algo/scan/border_grid.h"
#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

/// Options for spurs. A spur is a short line by which a ring reaches into a corner that a round
/// spot leaves unmelted. At the ring's corner the laser moves outwards to the corner of the area to
/// be melted, and back. The area that a spur melts a second time is about twice as large as its
/// newly melted area. Blunt corners leave almost nothing unmelted, so they have no spurs.
struct SpurFill {
  double spot_nm = 0;
  double least_nm = 0;  ///< length below which spurs are omitted
};

/// Returns a ring with spurs into the gap between the ring and the area that the next outer ring
/// melts. Spurs follow bisectors until the spot touches the gap's tip. A tip narrower than a
/// quarter of the spot remains unmelted.
///
/// ring, around: convex, counter-clockwise; `around` is the gap's outer boundary and contains the
/// ring. Cost: O(n), n corners, and O(n) for each spur.
ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill);

/// Returns the outermost ring of a piece, `gap_nm` inside of it, with spurs into the corners that a
/// cut has made. If one side of the corner is on the region's boundary, the spur is parallel to
/// this side. So the spur is not nearer to the boundary than the ring. Otherwise the spur
/// follows the bisector. Every point of a spur keeps the ring's distance from the boundary. A spur
/// is at most kLongestSpur gaps long.
///
/// border: the region's boundary, with a reach of at least SpurReach(gap_nm). Cost: O(n), n
/// corners, and the boundary near each sharp corner.
ConvexRing WithOuterSpurs(const ConvexRing& ring, double gap_nm, const BorderGrid& border,
                          const SpurFill& fill);

/// Returns the approximate share of a piece's area, in its corners, that rings without spurs do not
/// melt. REQUIRES: counter-clockwise. Cost: O(n), n corners.
double OpenShare(const ConvexRing& piece, double pitch_nm, const SpurFill& fill);

/// Largest length of a spur, in gaps (WithOuterSpurs). Only a corner below 12 degrees would need a
/// longer spur: its unmelted area is too small to be visible.
inline constexpr double kLongestSpur = 10;

/// Returns the largest distance from the boundary that WithOuterSpurs queries.
double SpurReach(double gap_nm);

}  // namespace slicefarm::exposure
