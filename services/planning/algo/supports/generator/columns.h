#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/clearance.h"
#include "services/planning/algo/supports/generator/support_heights.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Contact areas of supports, indexed by layer of support: in each layer, the free part of the
/// undersides that this layer supports directly.
using Contacts = std::vector<MultiPolygon>;

/// Returns vertical columns under contacts, indexed by layer of support. Each layer has the columns
/// of the layer above and its new contacts, without the blocked areas (Clearance). Columns end on
/// the bed or on the part.
///
/// Snug style: new contacts are grown by a line's width, and gaps narrower than twice the closing
/// radius are closed. Grid style: new contacts are grown to cells of half the spacing, so that
/// columns keep the same shape over many layers. With both styles, the grown area is omitted close
/// below undersides of the part that need no support. So every top near the part is at the
/// requested distance.
///
/// A column that is too slender for a closed cell of lines is widened, from 2 to 4 mm below its top
/// down, if there is free space. No column may end on other objects; with bed_only no column may
/// end on the part. Columns that would end there are omitted completely.
///
/// The area of the layer above is stored as pixels of kColumnPixelNm, or larger for parts over 300
/// mm. Contacts, and the sides of columns towards the part, are exact. Errors: Cancelled. Cost:
/// some 2 ns per pixel and layer, and one boolean operation per layer, on `threads` threads.
absl::StatusOr<std::vector<MultiPolygon>> Columns(const SupportProblem& problem,
                                                  const SupportHeights& heights,
                                                  const Contacts& contacts,
                                                  const Clearance& clearance,
                                                  const SupportOptions& options, int threads,
                                                  const CancelToken& cancel);

inline constexpr Coord kColumnPixelNm = 250'000;

}  // namespace slicefarm::planning
