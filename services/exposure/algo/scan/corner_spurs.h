#pragma once

#include "services/exposure/algo/scan/border_grid.h"
#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

/// Rings of convex pieces reach into corners that a round spot leaves open: from a sharp corner the
/// way goes out towards the corner of what is to be melted, and back. That melts about twice as
/// much again as it melts first, so blunt corners, which leave next to nothing open, have none.
struct SpurFill {
  double spot_nm = 0;
  double least_nm = 0;  ///< shorter spurs are left out
};

/// A ring with spurs into the gap between it and what the ring around it melts: along bisectors,
/// until the spot touches the gap's tip. Where the tip is narrower than a quarter of the spot it
/// stays open.
///
/// ring, around: convex, counter-clockwise; `around` is the gap's outer border, and has the ring
/// inside. Cost: O(n), and O(n) for each spur.
ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill);

/// The outermost ring of a piece, `gap_nm` inside of it, with spurs into those corners of the piece
/// that a cut has made: along the region's border, if one of the corner's sides is that, so that
/// nothing comes nearer to the border; else along the bisector. Of a spur, all of its way keeps as
/// far from the border as the ring does; it is no longer than kLongestSpur gaps.
///
/// border: of the region; its reach is SpurReach(gap_nm) or more.
/// Cost: O(n), and the border that is near for each sharp corner.
ConvexRing WithOuterSpurs(const ConvexRing& ring, double gap_nm, const BorderGrid& border,
                          const SpurFill& fill);

/// What rings without spurs leave open in the corners of a piece, as a share of it, about.
/// REQUIRES: counter-clockwise. Cost: O(n).
double OpenShare(const ConvexRing& piece, double pitch_nm, const SpurFill& fill);

/// In gaps. A corner that asks for more is sharper than 12 degrees: nothing to be seen stays open.
inline constexpr double kLongestSpur = 10;

/// Which distances from the border WithOuterSpurs asks for.
double SpurReach(double gap_nm);

}  // namespace slicefarm::exposure
