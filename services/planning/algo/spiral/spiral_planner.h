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

/// Makes one bead of the layers of a vase (spiral_vase). A hollow layer is a turn where it holds
/// nothing but one loop (SpiralLoop): no supports, no skirt, no hole, no neck too narrow for two
/// beads. Turns that follow each other begin where the one below ends, with the filament ready, at
/// the place of their loop that is nearest to it. Where a hollow layer is no turn it is printed like
/// any other, and a warning says where.
///
/// It has its say after all planners that decide on entries. Cost: one offset a layer.
class SpiralPlanner : public Planner {
 public:
  static bool IsNeeded(const PlanningOptions& options);

  /// InvalidArgument (SETTING_OUT_OF_RANGE) unless all copies are of one object, and one is printed
  /// after the other.
  static absl::Status Check(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  /// Both must outlive this.
  SpiralPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies)
      : options_(options), copies_(copies), skirt_reach_(options.skirt) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  /// The last layer but one is settled: whether its turn is the last is known.
  int32_t Settle(OpenLayers& layers) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Nothing: the layer is no turn.
  std::optional<Polygon> LoopOf(const SlicedLayer& layer) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  SkirtReach skirt_reach_;
  int32_t seen_ = 0;                ///< layers
  std::optional<Point> left_at_;    ///< where the last layer's turn ends
  bool goes_on_ = false;            ///< the last layer's turn follows another one
  int64_t hollow_ = 0;
  std::vector<Coord> no_turns_nm_;  ///< heights of hollow layers that are none
};

}  // namespace slicefarm::planning
