#pragma once

#include "common/model/layers/job_plan.h"
#include "common/stage/planning_stage.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/coordinator/remote/stage_client.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// Client of the planning service (stage_client.h).
class RemotePlanning : public PlanningStage {
 public:
  explicit RemotePlanning(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("planning", replicas, options) {}

  absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                               const PlanningOptions& options) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
