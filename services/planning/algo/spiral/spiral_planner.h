#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/model/options/planning_options.h"
#include "common/stage/stages.h"
#include "services/planning/algo/adhesion/skirt.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm::planning {

/// Plans the layers of a vase as one continuous bead (spiral_vase).
///
/// A hollow layer (ObjectSection::hollow) becomes a turn of the spiral if it has exactly one loop
/// (SpiralLoop). It must have no supports, no skirt, no hole, and no neck too narrow for two beads.
/// A turn begins at the point of its loop that is nearest to the end of the turn below, without a
/// retraction between them. A hollow layer that is no turn is printed like any other layer, and a
/// warning gives its height.
///
/// Runs after all planners that choose entry points. Cost: one offset per layer.
class SpiralPlanner : public Planner {
 public:
  /// Returns true if some object is printed as a spiral.
  static bool IsNeeded(const PlanningOptions& options);

  /// Checks the copies of a plate with spiral_vase. Errors: InvalidArgument (SETTING_OUT_OF_RANGE)
  /// for copies of several objects, or for several copies without complete_objects. OK if no object
  /// is printed as a spiral.
  static absl::Status Check(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  /// `options` and `copies` must outlive this planner.
  SpiralPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies)
      : options_(options), copies_(copies), skirt_reach_(options.skirt) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  /// Settles all layers below the last one, if the last one is a turn. Only the next layer decides
  /// whether this turn ends the spiral.
  int32_t Revise(OpenLayers& layers) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Returns the loop of a layer, or nullopt if the layer is no turn.
  std::optional<Polygon> LoopOf(const SlicedLayer& layer) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  SkirtReach skirt_reach_;
  int32_t seen_ = 0;  ///< number of layers so far
  /// end of the last layer's turn; nullopt if that layer is no turn
  std::optional<Point> left_at_;
  bool goes_on_ = false;  ///< true if the last layer's turn continues the turn below it
  int64_t hollow_ = 0;
  std::vector<Coord> no_turns_nm_;  ///< heights of hollow layers that are no turns
};

}  // namespace slicefarm::planning
