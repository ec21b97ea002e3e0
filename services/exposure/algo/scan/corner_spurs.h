#pragma once

#include "services/exposure/algo/scan/border_grid.h"
#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

/// Options for spurs: short lines by which rings of convex pieces reach into corners that a round
/// spot leaves unmelted. From a sharp corner the laser moves outwards to the corner of the area to
/// be melted, and back. A spur melts about twice as much material again as it newly melts. Blunt
/// corners leave almost nothing unmelted, so that they have no spurs.
struct SpurFill {
  double spot_nm = 0;
  double least_nm = 0;  ///< length below which spurs are omitted
};

/// Returns a ring with spurs into the gap between it and the area that the next outer ring melts.
/// Spurs follow bisectors until the spot touches the gap's tip. A tip narrower than a quarter of
/// the spot remains unmelted.
///
/// ring, around: convex, counter-clockwise; `around` is the gap's outer boundary and contains the
/// ring. Cost: O(n), n corners, and O(n) for each spur.
ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill);

/// Returns the outermost ring of a piece, `gap_nm` inside of it, with spurs into the corners that a
/// cut has made. If one of the corner's sides is on the region's boundary, the spur is parallel to
/// it, so that nothing is nearer to the boundary. Otherwise the spur follows the bisector. Every
/// point of a spur keeps the ring's distance from the boundary. A spur is at most kLongestSpur gaps
/// long.
///
/// border: the region's boundary, with a reach of at least SpurReach(gap_nm). Cost: O(n), n
/// corners, and the boundary near each sharp corner.
ConvexRing WithOuterSpurs(const ConvexRing& ring, double gap_nm, const BorderGrid& border,
                          const SpurFill& fill);

/// Returns the approximate share of a piece's area that rings without spurs leave unmelted in its
/// corners. REQUIRES: counter-clockwise. Cost: O(n), n corners.
double OpenShare(const ConvexRing& piece, double pitch_nm, const SpurFill& fill);

/// Largest length of a spur, in gaps. A corner that needs more is sharper than 12 degrees: its
/// unmelted area is too small to be visible.
inline constexpr double kLongestSpur = 10;

/// Returns the largest distance from the boundary that WithOuterSpurs queries.
double SpurReach(double gap_nm);

}  // namespace slicefarm::exposure
