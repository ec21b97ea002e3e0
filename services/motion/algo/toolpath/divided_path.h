#pragma once

#include "common/model/path.h"

namespace slicefarm::motion {

/// How far the one width of a bead may lie from the path's width at any place.
inline constexpr Coord kWidthToleranceNm = 10'000;

/// Beads longer than this follow the width more exactly: a taper of walls takes few more of them.
inline constexpr Coord kLongBeadNm = 1'000'000, kLongWidthToleranceNm = 5'000;

/// The flow lags behind shorter beads: more of them would not make the width more exact.
inline constexpr Coord kShortBeadNm = 400'000;

/// Returns the path with points added where its width changes along an edge. A bead has one width,
/// the mean of its ends; on each new edge that is within kWidthToleranceNm of the path's width, and
/// within kLongWidthToleranceNm where that takes no edges shorter than kLongBeadNm. Where edges
/// would have to be shorter than kShortBeadNm for this, edges of at least 0.0125 mm keep the steps
/// of the section at 27 %. Points of the path stay; so does its plastic, but for beads
/// narrower than high, whose mean width does not have their mean section. Cost: O(n), and the
/// points added.
Path DividedByWidth(Path path, Coord bead_height_nm);

}  // namespace slicefarm::motion
