#pragma once

#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stage_call.h"

namespace slicefarm {

struct PlanningOptions;
/// Stage that decides about the whole job before its layers are processed independently.
class PlanningStage {
 public:
  virtual ~PlanningStage() = default;
  virtual absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                                       const PlanningOptions& options) const = 0;
};

}  // namespace slicefarm
