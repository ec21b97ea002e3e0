#include "common/wire/stage_call_wire.h"

#include <fmt/core.h>

#include <string>

#include "common/base/build_info.h"
#include "common/base/error.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

constexpr size_t kMaxJobIdBytes = 256;

}  // namespace

v1::StageCall ToProto(const StageCall& call) {
  v1::StageCall proto;
  proto.set_job_id(call.job_id);
  proto.set_build_id(std::string(BuildId()));
  return proto;
}

absl::StatusOr<StageCall> FromProto(const v1::StageCall& proto) {
  if (proto.build_id() != BuildId()) {
    return MakeError(
        absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
        fmt::format("the caller is build {}, this is build {}", proto.build_id(), BuildId()),
        {{"caller", proto.build_id()}, {"callee", std::string(BuildId())}});
  }
  if (proto.job_id().size() > kMaxJobIdBytes) {
    return Malformed("job_id", fmt::format("longer than {} bytes", kMaxJobIdBytes));
  }
  StageCall call;
  call.job_id = proto.job_id();
  return call;
}

}  // namespace slicefarm
