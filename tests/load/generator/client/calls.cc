#include "tests/load/generator/client/calls.h"

#include <grpcpp/alarm.h>

#include <string>

#include "common/rpc/retry_after.h"

namespace slicefarm::load {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using std::chrono::system_clock;

/// Calls `next` at the time `time`.
void At(system_clock::time_point time, std::function<void()> next) {
  auto* alarm = new grpc::Alarm;
  alarm->Set(time, [alarm, next = std::move(next)](bool) {
    next();
    delete alarm;  // the alarm owns this function until it returns
  });
}

/// Call with its attempts. It exists until the last attempt has ended.
class PersistentCall : public std::enable_shared_from_this<PersistentCall> {
 public:
  PersistentCall(std::string_view step, const CallContext& context, Attempt attempt, Ended ended)
      : step_(step),
        context_(context),
        attempt_(std::move(attempt)),
        ended_(std::move(ended)),
        begin_(steady_clock::now()) {}

  void Try() {
    attempt_([self = shared_from_this()](absl::Status status) { self->Decide(std::move(status)); });
  }

 private:
  void Decide(absl::Status status) {
    const milliseconds rest = rpc::RetryAfter(status);
    const system_clock::time_point again = system_clock::now() + rest;
    if (context_.retry && rest > milliseconds(0) && again < context_.deadline) {
      context_.log->Add(Tally::kRetries);
      return At(again, [self = shared_from_this()] { self->Try(); });
    }
    if (status.ok()) {
      const std::chrono::nanoseconds took = steady_clock::now() - begin_;
      context_.log->StepTook(step_, took.count());
    }
    ended_(std::move(status));
  }

  const std::string step_;
  const CallContext context_;
  const Attempt attempt_;
  const Ended ended_;
  const steady_clock::time_point begin_;
};

}  // namespace

void MakeCall(std::string_view step, const CallContext& context, Attempt attempt, Ended ended) {
  std::make_shared<PersistentCall>(step, context, std::move(attempt), std::move(ended))->Try();
}

}  // namespace slicefarm::load
