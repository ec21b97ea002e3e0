#include "services/planning/algo/local_planning_stage.h"

#include <utility>

#include "common/model/options/planning_options.h"
#include "services/planning/algo/job_planner.h"

namespace slicefarm::planning {
namespace {

class LocalPlanning : public PlanningStage {
 public:
  absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                               const PlanningOptions& options) const override {
    absl::StatusOr<JobPlanner> planner =
        JobPlanner::Make(options, job.copies, job.object_names, call.threads);
    if (!planner.ok()) return planner.status();
    for (const SlicedLayer& layer : job.layers) {
      if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
      if (absl::Status planned = planner->Next(layer); !planned.ok()) return planned;
    }
    return planner->Finish(call.cancel);
  }
};

}  // namespace

std::unique_ptr<PlanningStage> MakeLocalPlanning() { return std::make_unique<LocalPlanning>(); }

}  // namespace slicefarm::planning
