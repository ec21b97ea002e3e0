#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layer.h"
#include "services/beading/algo/classic/constant_walls.h"
#include "services/beading/algo/classic/gap_fill.h"

namespace slicefarm::beading {

/// An island with walls of constant width, and beads of varying width in the gaps that they leave.
/// The object is left to the caller.
absl::StatusOr<WalledIsland> MakeClassicIsland(const PolygonWithHoles& outline,
                                               const WallPlan& plan,
                                               const GapFillOptions& gap_options,
                                               const CancelToken& cancel);

}  // namespace slicefarm::beading
