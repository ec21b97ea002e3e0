#include "common/rpc/server/admission.h"

#include <chrono>
#include <string>

#include "common/base/error.h"
#include "common/rpc/retry_after.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {
namespace {

constexpr int kRetryAfter = 200;  // in ms

}  // namespace

Admission::Ticket::~Ticket() {
  if (admission_ != nullptr) admission_->Leave();
}

absl::StatusOr<Admission::Ticket> Admission::Enter(const CancelToken& cancel) {
  std::unique_lock lock(mutex_);
  if (working_ >= slots_ && waiting_ >= queue_) {
    return MakeError(
        absl::StatusCode::kResourceExhausted, Reason::kOverloaded,
        "the server is busy: it works on as many calls as it accepts, and its queue is full",
        {{"limit", std::to_string(slots_ + queue_)}, {kRetryAfterMs, std::to_string(kRetryAfter)}});
  }
  ++waiting_;
  while (working_ >= slots_) {
    left_.wait_for(lock, kPollCancel);
    if (working_ < slots_) break;
    lock.unlock();  // polling the token may lock other mutexes
    const absl::Status wanted = cancel.Check();
    lock.lock();
    if (!wanted.ok()) {
      --waiting_;
      return wanted;
    }
  }
  --waiting_;
  ++working_;
  return Ticket(this);
}

void Admission::Leave() {
  {
    const std::lock_guard lock(mutex_);
    --working_;
  }
  left_.notify_one();
}

int Admission::working() const {
  const std::lock_guard lock(mutex_);
  return working_;
}

int Admission::waiting() const {
  const std::lock_guard lock(mutex_);
  return waiting_;
}

}  // namespace slicefarm::rpc
