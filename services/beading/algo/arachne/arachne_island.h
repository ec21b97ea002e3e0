#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/beading/algo/arachne/variable_walls.h"
#include "services/beading/algo/beads/island_beads.h"
#include "services/beading/algo/classic/constant_walls.h"
#include "services/beading/algo/classic/gap_fill.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// Makes the walls of a layer's islands, with variable width where needed.
class ArachneIslands {
 public:
  /// `plan`: the layer's walls for constant width (constant_walls.h), from which widths and the
  /// number of walls are taken. `deciding_radius`: see VariableWallOptions; may be empty. REQUIRES:
  /// plan.perimeters > 0.
  ArachneIslands(const BeadingOptions& options, const WallPlan& plan,
                 const GapFillOptions& gap_options,
                 std::function<double(double x, double y, double radius_nm)> deciding_radius);

  /// Returns the walls of an island; nullopt if MakeVariableWalls returns nullopt for it. Errors:
  /// Cancelled.
  absl::StatusOr<std::optional<IslandBeads>> Make(const PolygonWithHoles& outline,
                                                  const CancelToken& cancel) const;

 private:
  Path PathOf(WallLine line) const;

  Coord least_edge_nm_ = 0;
  Coord edge_deviation_nm_ = 0;
  WallPlan plan_;
  GapFillOptions gap_options_;
  VariableWallOptions wall_options_;
  std::unique_ptr<const BeadingStrategy> strategy_;
};

}  // namespace slicefarm::beading
