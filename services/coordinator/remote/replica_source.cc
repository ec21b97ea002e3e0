#include "services/coordinator/remote/replica_source.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "common/base/error.h"
#include "common/rpc/retry_after.h"
#include "common/stage/job_memory.h"

namespace slicefarm::coordinator {
namespace {

using std::chrono::milliseconds;

/// Shortest pause before a retry. It applies also if the server names no time.
constexpr milliseconds kLeastWait{20};
constexpr milliseconds kMaxWait{2'000};

}  // namespace

bool IsReplicasFault(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsPermissionDenied(status) ||
         absl::IsUnauthenticated(status) || DetailOf(status).reason == Reason::kBuildMismatch;
}

absl::Status LostCall(std::string_view stage, std::string_view what, std::string_view how) {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   fmt::format("{} {}", stage, how),
                   {{"stage", std::string(stage)}, {"lost", std::string(what)}});
}

bool WasLost(const absl::Status& status) { return DetailOf(status).metadata.contains("lost"); }

bool IsOverloaded(const absl::Status& status) {
  return absl::IsResourceExhausted(status) && DetailOf(status).reason == Reason::kOverloaded &&
         !IsOutOfMemory(status);
}

absl::Status AwaitRetry(const absl::Status& overloaded, const CancelToken& cancel) {
  return rpc::AwaitRetry(std::clamp(rpc::RetryAfter(overloaded), kLeastWait, kMaxWait), cancel);
}

absl::Status SingleReplica::Call(const CancelToken& cancel, const Attempt& attempt) {
  absl::Status status = attempt(channel_);
  while (IsOverloaded(status)) {
    if (absl::Status wanted = AwaitRetry(status, cancel); !wanted.ok()) return wanted;
    status = attempt(channel_);
  }
  return status;
}

}  // namespace slicefarm::coordinator
