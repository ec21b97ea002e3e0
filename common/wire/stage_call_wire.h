#pragma once

#include "absl/status/statusor.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

/// Converts the context of a call. Each call of a stage begins with this context. Cancellation and
/// deadline are not part of the message, because gRPC transfers them.
v1::StageCall ToProto(const StageCall& call);

/// Returns the context of a call. Errors: FailedPrecondition, reason BUILD_MISMATCH with `caller`
/// and `callee`, if the caller has another build (build_info.h). The stages of another build might
/// not give the same bytes.
absl::StatusOr<StageCall> FromProto(const v1::StageCall& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
