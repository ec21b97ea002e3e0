#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/support/clearance.h"
#include "services/planning/algo/support/support_heights.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// What supports lie against, by layer of support: what is free of all contacts on it.
using Contacts = std::vector<MultiPolygon>;

/// Upright columns under contacts, by layer of support: at each layer what stood above and what is
/// new there, less what is not free. They end on the bed or on the part.
///
/// Snug: new contacts are grown by a line's width, and gaps between them narrower than twice the
/// closing radius are closed. Grid: they are grown to cells of half the spacing, in which they are
/// alike over many layers. Neither goes where the part's underside is near and nothing is to be
/// carried, so that all tops near the part are at the distance asked for.
/// A column that stays too slender for a closed cell of lines is made wider from 2 to 4 mm below its top on, where there
/// is room.
/// With bed_only nothing of a column stands on the part; on other objects none ever does: what
/// would is left out from its top down.
///
/// What stood above is known as pixels of kColumnPixelNm, or more on parts over 300 mm; contacts,
/// and the edges towards the part, are exact.
/// Errors: Cancelled.
/// Cost: some 2 ns a pixel and layer, and a boolean operation a layer, on `threads` threads.
absl::StatusOr<std::vector<MultiPolygon>> Columns(const SupportProblem& problem,
                                                  const SupportHeights& heights,
                                                  const Contacts& contacts,
                                                  const Clearance& clearance,
                                                  const SupportOptions& options, int threads,
                                                  const CancelToken& cancel);

inline constexpr Coord kColumnPixelNm = 250'000;

}  // namespace slicefarm::planning
