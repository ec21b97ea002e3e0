#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/beading/algo/beads/island_beads.h"
#include "services/beading/algo/classic/constant_walls.h"
#include "services/beading/algo/classic/gap_fill.h"

namespace slicefarm::beading {

/// Makes the walls of an island, with constant width, and beads of variable width in the gaps
/// between them. Errors: Cancelled.
absl::StatusOr<IslandBeads> MakeClassicIsland(const PolygonWithHoles& outline, const WallPlan& plan,
                                              const GapFillOptions& gap_options,
                                              const CancelToken& cancel);

}  // namespace slicefarm::beading
