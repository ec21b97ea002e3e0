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

/// Where the calls of a remote stage go. Thread-safe.
class ReplicaSource {
 public:
  /// One try of a call; may be made again, on another channel.
  using Attempt = std::function<absl::Status(const std::shared_ptr<grpc::Channel>& channel)>;

  virtual ~ReplicaSource() = default;

  /// Makes the call on a replica, and on others as long as it says something only of the replica
  /// that it failed.
  virtual absl::Status Call(const CancelToken& cancel, const Attempt& attempt) = 0;
};

/// One server and no other: who calls has his own plan for its failing.
class SingleReplica : public ReplicaSource {
 public:
  explicit SingleReplica(std::shared_ptr<grpc::Channel> channel) : channel_(std::move(channel)) {}

  absl::Status Call(const CancelToken& cancel, const Attempt& attempt) override;

  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }

 private:
  const std::shared_ptr<grpc::Channel> channel_;  // gRPC's own handle
};

/// True if the status says that this server cannot take the call, or not from us, while another one
/// may.
bool IsReplicasFault(const absl::Status& status);

/// Says of a call that it was under way when nothing more was heard of its server: the connection
/// broke, or no answer came in time. Whoever sees it again may think that the call is what the
/// servers die of. `what` was lost: "connection" or "answer".
absl::Status LostCall(std::string_view stage, std::string_view what, std::string_view how);
bool WasLost(const absl::Status& status);

/// True if the server is there and takes no more calls for now; not if this process has no room.
bool IsOverloaded(const absl::Status& status);

/// Lets pass the time that an overloaded server asked for, or less if `cancel` asks. Returns
/// Cancelled then.
absl::Status AwaitRetry(const absl::Status& overloaded, const CancelToken& cancel);

}  // namespace slicefarm::coordinator
