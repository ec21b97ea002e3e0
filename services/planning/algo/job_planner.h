#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/planning/algo/planner/planner.h"
#include "services/planning/algo/planner/region_planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Plans a job in two phases.
///
/// First, region planners add stacks with layers of their own. Each region planner gets the layers
/// of all parts, and the stacks that earlier planners added. Then the heights of all stacks are
/// merged into the layers of the print (common/stage/print_layers.h):
///
///   1 supports below parts that would be printed into the air (supports/planner/).
///   2 rafts    below objects and supports (adhesion/raft_planner.h).
///
/// Second, planners process the layers of the print, bottom up, in this order:
///
///   1 seams    start points of walls (seams/seam_planner.h).
///   2 travel   entry points of layers, objects and copies (travel/travel_planner.h).
///   3 sequence order of copies with complete_objects (sequence/sequence_planner.h).
///   4 spiral   turns of a vase with spiral_vase (spiral/spiral_planner.h).
///   5 curl     curled edges of overhangs, which travels avoid (curl/curl_planner.h).
///   6 air      areas with nothing below them (air/air_planner.h).
///   7 adhesion brims and the skirt, which add no heights (adhesion/adhesion_planner.h).
///   8 conflicts overlaps of structures (conflicts/conflict_planner.h).
///   9 infill   lines and areas of infill that depend on many layers (infill/infill_planner.h).
///
/// A job without region planners is planned while its layers arrive. A layer's plan can be taken
/// (TakeFinished) as soon as no planner will change it. Memory is then the data of the planners: a
/// few layers each, a bounded number of possible points of seams, and the layers for infill that
/// grows down from above. A job with region planners stores all layers until the last one has
/// arrived.
///
/// Some results need the whole job. An enabled draft shield surrounds all layers and is as high as
/// the job. The sequence of copies depends on their heights.
///
/// Only the planning of supports uses several threads. The plan depends on the arguments alone, not
/// on the number of threads.
class JobPlanner {
 public:
  /// All arguments must outlive the planner. `object_names`: names for messages, indexed by object;
  /// may have fewer entries than objects.
  ///
  /// Errors: REQUEST_MALFORMED for copies of objects without options, or for a raft that does not
  /// have exactly one index of region settings per layer. OBJECTS_COLLIDE for copies that are
  /// printed one after the other and have rafts of different heights. SETTING_OUT_OF_RANGE, see
  /// SpiralPlanner::Check.
  static absl::StatusOr<JobPlanner> Make(const PlanningOptions& options,
                                         std::span<const PlacedCopy> copies,
                                         std::span<const std::string> object_names = {},
                                         int threads = 1);

  /// Plans the next layer of the parts; call it from the lowest layer up. Heights are measured from
  /// each part's own bottom. Errors: REQUEST_MALFORMED for sections of objects without options, or
  /// for sections of stacks other than parts.
  absl::Status Next(const SlicedLayer& layer);

  /// Returns the finished plans, from the lowest layer up: the plans that no planner will change
  /// any more. Plans that earlier calls have returned are not in the result.
  std::vector<LayerPlan> TakeFinished();

  /// Returns the memory in bytes that is used for past layers. The bounded memory for the most
  /// recent layers is not included.
  int64_t HeldBytes() const;

  /// Returns the plan without the layers that TakeFinished has returned. Call once, after the last
  /// layer. Errors: any error of the planners; REQUEST_TOO_LARGE for too many layers of the print;
  /// Cancelled.
  absl::StatusOr<JobPlan> Finish(const CancelToken& cancel = {});

 private:
  JobPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
             std::span<const std::string> object_names, int threads);

  /// Runs the region planners, then plans all layers of the print.
  absl::Status PlanRegions(const CancelToken& cancel, JobPlan& plan);
  /// Plans one layer of the print. `above_supports`: areas above supports, as in RegionPlan. The
  /// areas of this layer are moved from `above_supports` into the layer's plan.
  void LookAt(const SlicedLayer& layer, RegionPlan::AreasAboveSupports& above_supports);

  const PlanningOptions* options_;
  std::span<const PlacedCopy> copies_;
  std::vector<std::unique_ptr<RegionPlanner>> region_planners_;
  std::vector<SlicedLayer> parts_;  ///< layers of the parts so far; empty without region planners
  int64_t parts_bytes_ = 0;
  std::vector<std::unique_ptr<Planner>> planners_;
  OpenLayers layers_;
  int32_t finished_ = 0;  ///< number of layers, from the first, with plans that are finished
};

}  // namespace slicefarm::planning
