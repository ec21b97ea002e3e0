#include "common/rpc/client/client_call.h"

#include <string>

#include "common/base/error.h"
#include "common/rpc/observe/trace_metadata.h"
#include "common/rpc/retry_after.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {

ClientCall::ClientCall(const ClientCallOptions& options) : cancel_(options.cancel) {
  context_.set_deadline(std::chrono::system_clock::now() + options.deadline);
  SetTrace(options.trace, &context_);
}

ClientCall::~ClientCall() {
  queue_.Shutdown();
  void* tag = nullptr;
  bool ok = false;
  while (queue_.Next(&tag, &ok)) {
  }
}

void ClientCall::CancelIfUnwanted() {
  if (cancelled_ || !cancel_.Cancelled()) return;
  cancelled_ = true;
  context_.TryCancel();
}

ClientCall::Done ClientCall::AwaitAny() {
  Done done;
  do {
    CancelIfUnwanted();
  } while (queue_.AsyncNext(&done.tag, &done.ok, std::chrono::system_clock::now() + kPollCancel) ==
           grpc::CompletionQueue::TIMEOUT);
  return done;
}

absl::Status ClientCall::Outcome(const grpc::Status& status) const {
  if (status.ok()) return absl::OkStatus();
  if (cancelled_) {
    return MakeError(absl::StatusCode::kCancelled, Reason::kCancelled, "the call was cancelled");
  }
  if (status.error_code() == grpc::StatusCode::CANCELLED) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "the server cancelled the call: " + status.error_message());
  }
  return FromGrpc(status);
}

}  // namespace slicefarm::rpc
