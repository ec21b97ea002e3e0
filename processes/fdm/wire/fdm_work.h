#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/wire/shared_wire.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// An FdmTask without its outlines and its job.
struct FdmWork {
  LayerRange range;
  std::vector<LayerPlan> plans;  ///< one per layer of the range
};

/// Converts a task to its message. Errors: REQUEST_MALFORMED and REQUEST_TOO_LARGE with the path to
/// the field.
absl::Status ToProto(const FdmWork& work, v1::FdmWork* proto);
/// Converts a message to a task. Errors: REQUEST_MALFORMED and REQUEST_TOO_LARGE with the path to
/// the field.
absl::StatusOr<FdmWork> FromProto(const v1::FdmWork& proto);

absl::Status ToProto(const FdmShared& job, v1::FdmShared* proto);
absl::StatusOr<FdmShared> FromProto(const v1::FdmShared& proto);

namespace v1 {
using slicefarm::FromProto;  // templates find it by the message's namespace
}  // namespace v1

template <>
struct MessageOf<FdmShared> {
  using Type = v1::FdmShared;
};

}  // namespace slicefarm
