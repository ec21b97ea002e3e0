#include "services/coordinator/remote/remote_call.h"

#include <fmt/core.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm::coordinator {

absl::Status BadAnswer(std::string_view stage, const absl::Status& why) {
  return MakeError(
      absl::StatusCode::kInternal, Reason::kInternal,
      fmt::format("{} answered what does not fit the call: {}", stage, std::string(why.message())),
      {{"stage", std::string(stage)}});
}

absl::Status OutcomeOf(std::string_view stage, const RemoteOptions& options, absl::Status status) {
  if (!absl::IsDeadlineExceeded(status)) return status;
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   fmt::format("{} did not answer within {:.0f} s", stage,
                               std::chrono::duration<double>(options.deadline).count()),
                   {{"stage", std::string(stage)}});
}

}  // namespace slicefarm::coordinator
