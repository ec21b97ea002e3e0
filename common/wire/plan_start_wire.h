#pragma once

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "common/model/options/planning_options.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stage_call.h"
#include "slicefarm/v1/planning.pb.h"

namespace slicefarm {

/// First message of a call of the planning stage.
struct PlanStart {
  StageCall call;
  PlanningOptions options;
  std::vector<PlacedCopy> copies;
  std::vector<std::string> object_names;  ///< object names, indexed by object, for error messages
};

absl::Status ToProto(const PlanStart& start, v1::PlanStart* proto);

/// Returns the start of a call. Errors: see stage_call_wire.h, plan_wire.h and options_check.h,
/// with the path to the field.
absl::StatusOr<PlanStart> FromProto(const v1::PlanStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
