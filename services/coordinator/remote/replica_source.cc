#include "services/coordinator/remote/replica_source.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <thread>

#include "common/model/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPollCancel{20};
constexpr milliseconds kMaxWait{2'000};

milliseconds WaitAskedFor(const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  const auto asked = detail.metadata.find(rpc::kRetryAfterMs);
  int64_t ms = 0;
  if (asked != detail.metadata.end()) {
    const std::string& text = asked->second;
    std::from_chars(text.data(), text.data() + text.size(), ms);
  }
  return std::clamp(milliseconds(ms), kPollCancel, kMaxWait);
}

}  // namespace

bool IsReplicasFault(const absl::Status& status) {
  return absl::IsUnavailable(status) || DetailOf(status).reason == Reason::kBuildMismatch;
}

bool IsOverloaded(const absl::Status& status) {
  return absl::IsResourceExhausted(status) && DetailOf(status).reason == Reason::kOverloaded;
}

absl::Status AwaitRetry(const absl::Status& overloaded, const CancelToken& cancel) {
  for (milliseconds left = WaitAskedFor(overloaded); left > milliseconds(0); left -= kPollCancel) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    std::this_thread::sleep_for(std::min(left, kPollCancel));
  }
  return cancel.Check();
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
