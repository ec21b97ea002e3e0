#pragma once

#include <grpcpp/channel.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"

namespace slicefarm::coordinator {

/// Set of replicas that get the calls of a remote stage. Thread-safe.
class ReplicaSource {
 public:
  /// One try of a call. It may be made again on another channel.
  using Attempt = std::function<absl::Status(const std::shared_ptr<grpc::Channel>& channel)>;

  virtual ~ReplicaSource() = default;

  /// Makes the call on a replica. Tries other replicas as long as the error concerns only the
  /// replica.
  virtual absl::Status Call(const CancelToken& cancel, const Attempt& attempt) = 0;
};

/// Single server without alternatives. The caller itself handles a failure of the server.
class SingleReplica : public ReplicaSource {
 public:
  explicit SingleReplica(std::shared_ptr<grpc::Channel> channel) : channel_(std::move(channel)) {}

  absl::Status Call(const CancelToken& cancel, const Attempt& attempt) override;

  /// Returns the channel to the server.
  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }

 private:
  const std::shared_ptr<grpc::Channel> channel_;  // gRPC's own handle
};

/// Returns true if the error concerns only this server: it cannot take the call, or refuses this
/// client. Another server may take the call.
bool IsReplicasFault(const absl::Status& status);

/// Returns the error of a call that was in progress when its server was lost. `what` was lost:
/// "connection" or "answer". Callers that see the error twice may suspect that the servers die of
/// the call.
absl::Status LostCall(std::string_view stage, std::string_view what, std::string_view how);
/// Returns true if the status is a LostCall error.
bool WasLost(const absl::Status& status);

/// Returns true if the server runs but takes no more calls for now. Returns false if this process
/// is out of memory.
bool IsOverloaded(const absl::Status& status);

/// Waits for the time that an overloaded server requested. Returns early with Cancelled if `cancel`
/// is cancelled.
absl::Status AwaitRetry(const absl::Status& overloaded, const CancelToken& cancel);

}  // namespace slicefarm::coordinator
