#pragma once

#include "absl/status/status.h"
#include "common/model/job_plan.h"
#include "common/model/layer.h"

namespace slicefarm::planning {

/// Decides one thing over a whole job. Planners run one after the other on each layer, bottom up,
/// and each adds to the plan; see JobPlanner for their order.
class Planner {
 public:
  virtual ~Planner() = default;

  /// Looks at the next layer. `plan` is that layer's.
  virtual void Look(const SlicedLayer& layer, LayerPlan& plan) = 0;

  /// After the last layer: adds what depends on more layers than one.
  virtual absl::Status Finish(JobPlan& plan) {
    (void)plan;
    return absl::OkStatus();
  }
};

/// The plan of an object's section in a layer; made if there is none.
SectionPlan& PlanOf(int32_t object, LayerPlan& plan);

}  // namespace slicefarm::planning
