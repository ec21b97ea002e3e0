#include "services/coordinator/remote/remote_call.h"

#include <fmt/core.h>

#include <string>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "common/stage/job_memory.h"

namespace slicefarm::coordinator {

absl::Status BadAnswer(std::string_view stage, const absl::Status& why) {
  if (IsOutOfMemory(why) || absl::IsCancelled(why)) return why;
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   fmt::format("{} sent an answer that does not fit the call: {}", stage,
                               std::string(why.message())),
                   {{"stage", std::string(stage)}});
}

absl::Status OutcomeOf(std::string_view stage, std::chrono::milliseconds deadline,
                       absl::Status status) {
  if (absl::IsDeadlineExceeded(status))
    return LostCall(stage, "answer",
                    fmt::format("did not answer within {:.0f} s",
                                std::chrono::duration<double>(deadline).count()));
  if (DetailOf(status).metadata.contains(rpc::kConnectionBroke))
    return LostCall(stage, "connection", "was lost: " + std::string(status.message()));
  if (absl::IsUnimplemented(status))
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
                     fmt::format("the server at {} is another service, or of another build: {}",
                                 stage, std::string(status.message())),
                     {{"stage", std::string(stage)}});
  return status;
}

}  // namespace slicefarm::coordinator
