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

/// Sends servers what their calls name and they do not keep. Whoever answers SHARED_MISSING is sent
/// that value, by one of the calls that want it, and called again: nobody needs to know what a
/// server keeps, so that it may be started anew, or forget, at any time. Thread-safe.
class SharedSends {
 public:
  /// `deadline`: of the sending of a value.
  explicit SharedSends(std::chrono::milliseconds deadline) : deadline_(deadline) {}

  /// `attempt` makes a call over `channel` that names `parts`. Errors: the attempt's; those of the
  /// sending; OVERLOADED from a server that forgets what it is sent before it is used.
  absl::Status Call(const std::shared_ptr<grpc::Channel>& channel, const StageCall& call,
                    const SharedParts& parts, const std::function<absl::Status()>& attempt);

 private:
  using Sending = std::pair<const grpc::Channel*, std::string>;  // and a digest

  absl::Status Send(const std::shared_ptr<grpc::Channel>& channel, const StageCall& call,
                    const SharedBytes& part) const;
  bool Begin(const Sending& sending, const StageCall& call);
  void End(const Sending& sending);

  const std::chrono::milliseconds deadline_;
  std::mutex mutex_;
  std::condition_variable sent_;
  std::set<Sending> sending_;
};

/// Replicas whose calls name `parts`: each is sent what it does not keep. What it is given must
/// outlive it.
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
