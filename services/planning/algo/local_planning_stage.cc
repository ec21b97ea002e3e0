#include "services/planning/algo/local_planning_stage.h"

#include <utility>

#include "services/planning/algo/job_planner.h"

namespace slicefarm::planning {
namespace {

class LocalPlanning : public PlanningStage {
 public:
  absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                               const PlanningOptions& options) const override {
    absl::StatusOr<JobPlanner> planner = JobPlanner::Make(options, job.copies, job.object_names);
    if (!planner.ok()) return planner.status();
    std::vector<LayerPlan> layers;
    layers.reserve(job.layers.size());
    for (const SlicedLayer& layer : job.layers) {
      if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
      absl::StatusOr<LayerPlan> plan = planner->Next(layer);
      if (!plan.ok()) return plan.status();
      layers.push_back(*std::move(plan));
    }
    absl::StatusOr<JobPlan> plan = planner->Finish(call.cancel);
    if (plan.ok()) plan->layers = std::move(layers);
    return plan;
  }
};

}  // namespace

std::unique_ptr<PlanningStage> MakeLocalPlanning() { return std::make_unique<LocalPlanning>(); }

}  // namespace slicefarm::planning
