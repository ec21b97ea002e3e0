#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "processes/mill/task/mill_task.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// Converts a task without its input. Errors: REQUEST_MALFORMED with the path to the field.
absl::Status ToProto(const MillTask& task, v1::MillWork* proto);
/// Converts a message to a task without its input. Errors: REQUEST_MALFORMED with the path to the
/// field.
absl::StatusOr<MillTask> FromProto(const v1::MillWork& proto);

namespace v1 {
using slicefarm::FromProto;  // templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
