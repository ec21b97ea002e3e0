#pragma once

#include "common/model/path.h"

namespace slicefarm::motion {

/// Largest difference between a bead's width and the path's width at any point, in nm.
inline constexpr Coord kWidthToleranceNm = 10'000;

/// Length above which a bead's width must be closer to the path's width, and the tolerance for
/// these beads. Tapering walls need only a few more beads for this.
inline constexpr Coord kLongBeadNm = 1'000'000, kLongWidthToleranceNm = 5'000;

/// Shortest useful bead. The flow lags behind shorter beads, so they would not make the width more
/// exact.
inline constexpr Coord kShortBeadNm = 400'000;

/// Returns the path with points added where its width changes along an edge. A bead has one width,
/// the mean of the widths at its ends.
/// - On each new edge this width is within kWidthToleranceNm of the path's width.
/// - It is within kLongWidthToleranceNm if no edge becomes shorter than kLongBeadNm.
/// - If edges would have to be shorter than kShortBeadNm, they are at least 0.0125 mm long, and the
///   section changes by 27 % per edge.
///
/// The result contains all points of the path. The amount of plastic does not change, except for
/// beads narrower than high: the section of their mean width is not their mean section. Cost: O(n),
/// where n includes the added points.
Path DividedByWidth(Path path, Coord bead_height_nm);

}  // namespace slicefarm::motion
