#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

/// Options for filling gaps.
struct GapFillOptions {
  Coord min_width_nm = 80'000;   ///< smallest width of a gap that is filled
  Coord max_width_nm = 800'000;  ///< largest width of a bead; a wider gap gets a bead of this width
  Coord layer_height_nm = 200'000;
  Coord min_length_nm = 0;   ///< smallest length of a bead; shorter ones are left out
  bool narrow_parts = true;  ///< FillNarrowParts fills parts; false: it leaves all to the infill
  /// Areas that a part must meet to be filled by FillNarrowParts; null: all parts are filled.
  const MultiPolygon* among = nullptr;
};

/// Smallest area of a bead in a gap between walls, or in a fill area that is narrow everywhere. A
/// smaller bead is a dot, 0.16 mm wide, which fills nothing visible.
inline constexpr double kLeastDotNm2 = 0.02 * kNmPerMm * kNmPerMm;
/// Smallest area of a bead in a narrow part of a fill area that also has wide parts. It is 0.4 mm3
/// in a layer of 0.2 mm, or 4.9 mm of a bead 0.45 mm wide. Smaller parts are left to the infill;
/// services/beading/README.md describes their total.
inline constexpr double kLeastNeckNm2 = 2 * kNmPerMm * kNmPerMm;

/// Returns beads of variable width along the middle of each gap (see MedialAxis). Between walls,
/// the bead's rectangle fills the gap. Along an outline, the bead stays inside. A bead that covers
/// less than kLeastDotNm2 is not worth its travel and is left out, as is one that is shorter than
/// the options allow.
///
/// Paths have Feature::kGapFill and one width per point (a single width if all are equal), in no
/// particular order. Errors: Cancelled.
absl::StatusOr<std::vector<Path>> FillGaps(const std::vector<Gap>& gaps,
                                           const GapFillOptions& options,
                                           const CancelToken& cancel);

/// Fills the parts of a fill area that are narrower than `max_width_nm`, removes them from
/// `fill_area` and returns their beads. Narrow parts are necks between wider parts, ends, and
/// islands that are narrow everywhere. The lines of the infill continue into a neck or an end, so
/// it is only filled here if its bead covers at least kLeastNeckNm2. Errors: Cancelled.
absl::StatusOr<std::vector<Path>> FillNarrowParts(const GapFillOptions& options,
                                                  const CancelToken& cancel,
                                                  MultiPolygon& fill_area);

}  // namespace slicefarm::beading
