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
  Coord max_width_nm = 800'000;  ///< largest width of a bead; wider regions are no gaps
  Coord layer_height_nm = 200'000;
};

/// Smallest area of a bead in a gap that infill does not fill. A smaller bead, a dot 0.16 mm wide,
/// fills nothing visible.
inline constexpr double kLeastDotNm2 = 0.02 * kNmPerMm * kNmPerMm;
/// Smallest area of a bead in a gap that infill also reaches: 0.4 mm3 in a layer of 0.2 mm, or 4.9
/// mm of a bead 0.45 mm wide. services/beading/README.md describes the smaller gaps and their
/// total.
inline constexpr double kLeastNeckNm2 = 2 * kNmPerMm * kNmPerMm;

/// Returns beads of variable width along the middle of each gap (see MedialAxis). Between walls,
/// the bead's rectangle fills the gap. Along an outline, the bead stays inside. A bead that covers
/// less than kLeastDotNm2 is not worth its travel and is left out.
///
/// Paths have Feature::kGapFill and one width per point (a single width if all are equal), in no
/// particular order.
absl::StatusOr<std::vector<Path>> FillGaps(const std::vector<Gap>& gaps,
                                           const GapFillOptions& options,
                                           const CancelToken& cancel);

/// Fills the parts of a fill area that are narrower than `max_width_nm` and removes them from the
/// area. These are necks between wider parts, ends, and areas that are narrow everywhere. A neck or
/// an end is left to the infill unless its bead covers kLeastNeckNm2, because the infill's own
/// lines continue into it.
absl::StatusOr<std::vector<Path>> FillNarrowParts(const GapFillOptions& options,
                                                  const CancelToken& cancel,
                                                  MultiPolygon& fill_area);

}  // namespace slicefarm::beading
