#pragma once

#include "absl/status/statusor.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

/// What begins every call of a stage; cancellation and deadline travel beside the message.
v1::StageCall ToProto(const StageCall& call);

/// Errors: FailedPrecondition, reason BUILD_MISMATCH with `caller` and `callee`, where the caller
/// is of another build: its other stages would not give the same bytes.
absl::StatusOr<StageCall> FromProto(const v1::StageCall& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
