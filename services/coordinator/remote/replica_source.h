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

/// Replicas of a service that get the calls of a remote stage. Thread-safe.
class ReplicaSource {
 public:
  /// Function that makes one try of a call over a channel. It may be called again with another
  /// channel.
  using Attempt = std::function<absl::Status(const std::shared_ptr<grpc::Channel>& channel)>;

  virtual ~ReplicaSource() = default;

  /// Makes the call on a replica. Tries another replica if the error concerns only the replica
  /// (IsReplicasFault).
  virtual absl::Status Call(const CancelToken& cancel, const Attempt& attempt) = 0;
};

/// Single server without alternatives. If the server fails, the caller gets the error.
class SingleReplica : public ReplicaSource {
 public:
  explicit SingleReplica(std::shared_ptr<grpc::Channel> channel) : channel_(std::move(channel)) {}

  absl::Status Call(const CancelToken& cancel, const Attempt& attempt) override;

  /// Returns the channel to the server.
  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }

 private:
  const std::shared_ptr<grpc::Channel> channel_;  // gRPC's own handle
};

/// Returns true if another server may take the call: this server cannot take the call, or refuses
/// this client.
bool IsReplicasFault(const absl::Status& status);

/// Returns the error of a call that was in progress when its server was lost. `what`: "connection"
/// or "answer", the one that was lost. `how`: description of the event. If the same call gets this
/// error twice, it may have killed the servers.
absl::Status LostCall(std::string_view stage, std::string_view what, std::string_view how);
/// Returns true if the status is a LostCall error.
bool WasLost(const absl::Status& status);

/// Returns true if the server is alive but refuses calls for now (OVERLOADED). Returns false if
/// this program is out of memory, which has the same status code.
bool IsOverloaded(const absl::Status& status);

/// Waits for the time that an overloaded server requested. Returns early with Cancelled if `cancel`
/// is cancelled.
absl::Status AwaitRetry(const absl::Status& overloaded, const CancelToken& cancel);

}  // namespace slicefarm::coordinator
