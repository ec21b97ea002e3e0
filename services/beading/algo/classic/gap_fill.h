#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

struct GapFillOptions {
  Coord min_width_nm = 80'000;   ///< narrower gaps stay empty
  Coord max_width_nm = 800'000;  ///< beads are not made wider
  Coord layer_height_nm = 200'000;
};

/// Beads of varying width along the middle of each gap (see MedialAxis). Beside walls a bead is as
/// wide as makes its rectangle fill the gap; along an outline it stays inside. Beads that cover
/// less than 0.02 mm2, a dot 0.16 mm wide, are left out: they cost a travel and fill nothing that
/// shows. Paths have Feature::kGapFill, one width a point (one in all where they are equal), and
/// are in no particular order.
absl::StatusOr<std::vector<Path>> FillGaps(const std::vector<Gap>& gaps,
                                           const GapFillOptions& options,
                                           const CancelToken& cancel);

}  // namespace slicefarm::beading
