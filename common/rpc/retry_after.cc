#include "common/rpc/retry_after.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <thread>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {
namespace {

using std::chrono::milliseconds;

}  // namespace

milliseconds RetryAfter(const absl::Status& error) {
  const ErrorDetail detail = DetailOf(error);
  const auto asked = detail.metadata.find(kRetryAfterMs);
  int64_t ms = 0;
  if (asked != detail.metadata.end()) {
    const std::string& text = asked->second;
    std::from_chars(text.data(), text.data() + text.size(), ms);
  }
  return milliseconds(std::max<int64_t>(ms, 0));
}

absl::Status AwaitRetry(milliseconds time, const CancelToken& cancel) {
  for (milliseconds left = time; left > milliseconds(0); left -= kPollCancel) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    std::this_thread::sleep_for(std::min(left, kPollCancel));
  }
  return cancel.Check();
}

}  // namespace slicefarm::rpc
