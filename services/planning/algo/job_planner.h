#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/planning_options.h"
#include "common/stage/stages.h"
#include "services/planning/algo/planner.h"

namespace slicefarm::planning {

/// Plans a job layer by layer, bottom up, so that layers can stream in, and their plans out as soon
/// as they are settled. What is kept is what the planners keep: a few layers each, but for places
/// of seams (a bounded number) and for infill that hangs from above. The planners, in the order in
/// which they look at a layer:
///
///   1 seams    where walls start (seams/seam_planner.h)
///   2 travel   where layers, objects and copies are entered and meet (travel/travel_planner.h)
///   3 sequence with complete_objects: which copy is printed when (sequence/sequence_planner.h)
///   4 adhesion rafts, brims and the skirt (adhesion/adhesion_planner.h)
///   5 infill   lines and places of sparse infill that depend on many layers
///   (infill/infill_planner.h)
///
/// What lies on the plate is known at the end alone: a draft shield goes round all that is above
/// it, and is as high as the job; the sequence of copies depends on their heights.
///
/// One thread; the plan depends on nothing but the arguments.
class JobPlanner {
 public:
  /// All must outlive this. `object_names`: by object, for messages; may be fewer. Errors:
  /// REQUEST_MALFORMED for copies of objects that have no options, or for an object whose raft has
  /// not a row of settings for each layer; OBJECTS_COLLIDE for copies that are printed one after
  /// the other and whose rafts are not of one height.
  static absl::StatusOr<JobPlanner> Make(const PlanningOptions& options,
                                         std::span<const PlacedCopy> copies,
                                         std::span<const std::string> object_names = {});

  /// Errors: REQUEST_MALFORMED for sections of objects that have no options.
  absl::Status Next(const SlicedLayer& layer);

  /// The plans that no planner will add to, but for those taken before; from the lowest layer up.
  std::vector<LayerPlan> TakeSettled();

  /// What is kept of the layers so far, beyond a bounded number of them.
  int64_t HeldBytes() const;

  /// The plan, but for the layers taken before. To be called once, after the last layer. Errors:
  /// those of the planners; Cancelled.
  absl::StatusOr<JobPlan> Finish(const CancelToken& cancel = {});

 private:
  JobPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
             std::span<const std::string> object_names);

  const PlanningOptions* options_;
  std::span<const PlacedCopy> copies_;
  std::vector<std::unique_ptr<Planner>> planners_;
  OpenLayers layers_;
  int32_t settled_ = 0;  ///< layers, from the first
};

}  // namespace slicefarm::planning
