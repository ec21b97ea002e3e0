#include "services/coordinator/remote/shared_sends.h"

#include <algorithm>
#include <string_view>

#include "common/base/error.h"
#include "common/base/shared/shared_cache.h"
#include "common/model/limits.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/retry_after.h"
#include "services/coordinator/remote/remote_call.h"
#include "slicefarm/v1/shared.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kSharing[] = "sharing";

/// Largest number of sends of one value during one call. A server forgets a value only when it
/// stores newer values.
constexpr int kSends = 3;

absl::Status Forgetful() {
  return MakeError(absl::StatusCode::kResourceExhausted, Reason::kOverloaded,
                   "the server drops shared values before they are used");
}

}  // namespace

absl::Status SharedSends::Call(const std::shared_ptr<grpc::Channel>& channel, const StageCall& call,
                               const SharedParts& parts,
                               const std::function<absl::Status()>& attempt) {
  for (int sends = 0;;) {
    absl::Status status = attempt();
    const std::string missing = MissingDigest(status);
    const auto part =
        std::ranges::find(parts, missing, [](const auto& known) { return known->digest; });
    if (missing.empty() || part == parts.end()) return status;
    const Sending sending(channel.get(), missing);
    if (!Begin(sending, call)) {  // another call has sent the value meanwhile
      if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
      continue;
    }
    status = Send(channel, call, **part);
    End(sending);
    if (!status.ok()) return status;
    if (++sends > kSends * std::ssize(parts)) return Forgetful();
  }
}

/// Returns true if the caller must send the value. Otherwise, waits until another call has sent it
/// or until `call` is cancelled.
bool SharedSends::Begin(const Sending& sending, const StageCall& call) {
  std::unique_lock lock(mutex_);
  if (sending_.insert(sending).second) return true;
  while (sending_.contains(sending)) {
    sent_.wait_for(lock, rpc::kPollCancel);
    lock.unlock();  // the cancellation check may take locks of its own
    const bool wanted = call.cancel.Check().ok();
    lock.lock();
    if (!wanted) break;
  }
  return false;
}

void SharedSends::End(const Sending& sending) {
  {
    const std::lock_guard lock(mutex_);
    sending_.erase(sending);
  }
  sent_.notify_all();
}

absl::Status SharedSends::Send(const std::shared_ptr<grpc::Channel>& channel, const StageCall& call,
                               const SharedBytes& part) const {
  using Stream = rpc::StreamCall<v1::KeepRequest, v1::KeepResponse>;
  v1::SharedValues::Stub stub(channel);
  Stream stream({deadline_, call.cancel, ChildSpan(call.trace, kSharing)},
                [&](auto* context, auto* queue) { return stub.PrepareAsyncKeep(context, queue); });
  v1::KeepRequest request;
  request.mutable_start()->set_kind(part.kind);
  request.mutable_start()->set_digest(part.digest);
  request.mutable_start()->set_size(std::ssize(part.bytes));
  std::string_view rest = part.bytes;
  while (stream.Write(request) && !rest.empty()) {
    const std::string_view piece = rest.substr(0, limits::kSharedPieceBytes);
    request.set_piece(piece.data(), piece.size());
    rest.remove_prefix(piece.size());
  }
  stream.WritesDone();
  v1::KeepResponse response;
  stream.Read(&response);
  return OutcomeOf(kSharing, deadline_, stream.Finish());
}

}  // namespace slicefarm::coordinator
