#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/wire/milling/mill_input_wire.h"
#include "processes/mill/task/mill_task.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// MillTask but its meshes, which follow. Errors of FromProto: REQUEST_MALFORMED and
/// MESH_TOO_LARGE with the way to the field.
absl::Status ToProto(const MillTask& task, v1::MillWork* proto);

struct MillWork {
  MillTask task;  ///< its input comes with `input`
  MillInputReader input;
};
absl::StatusOr<MillWork> FromProto(const v1::MillWork& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
