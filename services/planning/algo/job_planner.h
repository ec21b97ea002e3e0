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
/// Region planners add stacks with layers of their own. They look at all parts at once, each sees
/// what those before it added, and then the heights of all stacks become the layers of the print
/// (common/stage/print_layers.h):
///
///   1 supports what carries parts that would hang in the air (supports/supports_planner.h)
///   2 rafts    what objects and supports stand on (adhesion/raft_planner.h)
///
/// Planners then look at the layers of the print, bottom up, in this order:
///
///   1 seams    where walls start (seams/seam_planner.h)
///   2 travel   where layers, objects and copies are entered and meet (travel/travel_planner.h)
///   3 sequence with complete_objects: which copy is printed when (sequence/sequence_planner.h)
///   4 curl     where overhangs curl up, which travels keep off (curl/curl_planner.h)
///   5 adhesion brims and the skirt, which add no heights (adhesion/adhesion_planner.h)
///   6 conflicts what would be printed in the same place (conflicts/conflict_planner.h)
///   7 infill   lines and places of sparse infill that depend on many layers
///   (infill/infill_planner.h)
///
/// A job that asks for no region planner is planned as its layers stream in, and its plans stream
/// out as soon as they are settled. What is kept is what the planners keep: a few layers each, but
/// for places of seams (a bounded number) and for infill that hangs from above. Else all layers are
/// kept until the last one is there.
///
/// What lies on the plate is known at the end alone: a draft shield goes round all that is above
/// it, and is as high as the job; the sequence of copies depends on their heights.
///
/// One thread, but for supports; the plan depends on nothing but the arguments, and not on how many
/// threads there are.
class JobPlanner {
 public:
  /// All must outlive this. `object_names`: by object, for messages; may be fewer. Errors:
  /// REQUEST_MALFORMED for copies of objects that have no options, or for an object whose raft has
  /// not a row of settings for each layer; OBJECTS_COLLIDE for copies that are printed one after
  /// the other and whose rafts are not of one height.
  static absl::StatusOr<JobPlanner> Make(const PlanningOptions& options,
                                         std::span<const PlacedCopy> copies,
                                         std::span<const std::string> object_names = {},
                                         int threads = 1);

  /// The next layer of the parts, each from its own bottom. Errors: REQUEST_MALFORMED for sections
  /// of objects that have no options, or that are of no part.
  absl::Status Next(const SlicedLayer& layer);

  /// The plans that no planner will add to, but for those taken before; from the lowest layer up.
  std::vector<LayerPlan> TakeSettled();

  /// What is kept of the layers so far, beyond a bounded number of them.
  int64_t HeldBytes() const;

  /// The plan, but for the layers taken before. To be called once, after the last layer. Errors:
  /// those of the planners; REQUEST_TOO_LARGE for too many layers of the print; Cancelled.
  absl::StatusOr<JobPlan> Finish(const CancelToken& cancel = {});

 private:
  JobPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
             std::span<const std::string> object_names, int threads);

  /// Runs the region planners, then looks at the layers of the print.
  absl::Status PlanRegions(const CancelToken& cancel, JobPlan& plan);
  /// `carried`: as RegionPlan's; what the layer has of it goes into its plan.
  void LookAt(const SlicedLayer& layer, RegionPlan::Carried& carried);

  const PlanningOptions* options_;
  std::span<const PlacedCopy> copies_;
  std::vector<std::unique_ptr<RegionPlanner>> region_planners_;
  std::vector<SlicedLayer> parts_;  ///< all so far, where there are region planners
  int64_t parts_bytes_ = 0;
  std::vector<std::unique_ptr<Planner>> planners_;
  OpenLayers layers_;
  int32_t settled_ = 0;  ///< layers, from the first
};

}  // namespace slicefarm::planning
