#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/job_facts.h"
#include "common/model/job_plan.h"
#include "common/model/layer.h"
#include "common/model/options/fdm_settings.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// FdmTask but its outlines.
struct FdmWork {
  FdmSettings settings;
  LayerRange range;
  std::vector<LayerPlan> plans;  ///< one for each layer of the range
  std::vector<Copy> copies;
  JobFacts facts;
};

/// Errors: REQUEST_MALFORMED and REQUEST_TOO_LARGE with the way to the field.
absl::Status ToProto(const FdmWork& work, v1::FdmWork* proto);
absl::StatusOr<FdmWork> FromProto(const v1::FdmWork& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
