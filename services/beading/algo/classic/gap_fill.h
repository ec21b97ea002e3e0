#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

struct GapFillOptions {
  Coord min_width_nm = 80'000;   ///< narrower gaps stay empty
  Coord max_width_nm = 800'000;  ///< beads are not made wider, and what is wider is no gap
  Coord layer_height_nm = 200'000;
};

/// A bead that nothing else can take the place of: one that covers less, a dot 0.16 mm wide, fills
/// nothing that shows.
inline constexpr double kLeastDotNm2 = 0.02 * kNmPerMm * kNmPerMm;
/// A bead where the infill reaches too: 0.4 mm3 in a layer of 0.2 mm, 4.9 mm of a bead 0.45 mm
/// wide. What is below it, and how much that is: services/beading/README.md.
inline constexpr double kLeastNeckNm2 = 2 * kNmPerMm * kNmPerMm;

/// Beads of varying width along the middle of each gap (see MedialAxis). Beside walls a bead is as
/// wide as makes its rectangle fill the gap; along an outline it stays inside. A bead that covers
/// less than kLeastDotNm2 is not worth its travel, and left out. Paths have Feature::kGapFill, one
/// width a point (one in all where they are equal), and are in no particular order.
absl::StatusOr<std::vector<Path>> FillGaps(const std::vector<Gap>& gaps,
                                           const GapFillOptions& options,
                                           const CancelToken& cancel);

/// The same in the parts of a fill area that are narrower than `max_width_nm`, which are taken out
/// of it: necks between wider parts, ends, and areas that are narrow everywhere. A neck or an end
/// is the infill's, and stays, unless its bead is worth a travel beyond what the infill does there
/// (kLeastNeckNm2): the infill's own lines go on into it.
absl::StatusOr<std::vector<Path>> FillNarrowParts(const GapFillOptions& options,
                                                  const CancelToken& cancel,
                                                  MultiPolygon& fill_area);

}  // namespace slicefarm::beading
