#pragma once

#include <grpcpp/channel.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "common/base/shared/shared_bytes.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "services/coordinator/remote/replica_source.h"

namespace slicefarm::coordinator {

/// Sends shared values to servers that do not have them. A call contains only the digests of its
/// values. If a server answers SHARED_MISSING, one of the calls that need the value sends it; then
/// each call is repeated. The client does not record which server has which values, so a server may
/// restart or forget values at any time. Thread-safe.
class SharedSends {
 public:
  /// Creates an object without sends in progress. `deadline`: time limit for sending one value.
  explicit SharedSends(std::chrono::milliseconds deadline) : deadline_(deadline) {}

  /// Makes a call over `channel` with `attempt`. `parts`: shared values to which the call refers.
  /// Errors: errors of `attempt`; errors of sending a value; OVERLOADED if the server forgets the
  /// values again before the call uses them.
  absl::Status Call(const std::shared_ptr<grpc::Channel>& channel, const StageCall& call,
                    const SharedParts& parts, const std::function<absl::Status()>& attempt);

 private:
  using Sending = std::pair<const grpc::Channel*, std::string>;  // channel and digest

  absl::Status Send(const std::shared_ptr<grpc::Channel>& channel, const StageCall& call,
                    const SharedBytes& part) const;
  bool Begin(const Sending& sending, const StageCall& call);
  void End(const Sending& sending);

  const std::chrono::milliseconds deadline_;
  std::mutex mutex_;
  std::condition_variable sent_;
  std::set<Sending> sending_;
};

/// ReplicaSource for calls that refer to the shared values `parts`. Sends each replica the values
/// that it does not have. All arguments must outlive this object.
class SharingReplicas : public ReplicaSource {
 public:
  SharingReplicas(ReplicaSource& replicas, SharedSends& sends, const StageCall& call,
                  const SharedParts& parts)
      : replicas_(replicas), sends_(sends), call_(call), parts_(parts) {}

  absl::Status Call(const CancelToken& cancel, const Attempt& attempt) override {
    return replicas_.Call(cancel, [&](const std::shared_ptr<grpc::Channel>& channel) {
      return sends_.Call(channel, call_, parts_, [&] { return attempt(channel); });
    });
  }

 private:
  ReplicaSource& replicas_;
  SharedSends& sends_;
  const StageCall& call_;
  const SharedParts& parts_;
};

}  // namespace slicefarm::coordinator
