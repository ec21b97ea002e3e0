#pragma once

#include <grpcpp/security/credentials.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/remote/address_watch.h"
#include "services/coordinator/remote/replica_source.h"

namespace slicefarm::coordinator {

/// Options of a StagePool.
struct StagePoolOptions {
  int tries = 3;  ///< tries of one call, on different replicas if there are several
  /// Largest number of tries of one call that end with the loss of their replica. The call may be
  /// the reason that these replicas died.
  int lost_tries = 2;
  /// Time for which a failed replica is avoided while another replica is reachable.
  std::chrono::milliseconds rest{1'000};
  /// Longest time that a call waits for a reachable replica. It is longer than the restart of a
  /// replica takes.
  std::chrono::milliseconds connect_patience{15'000};
  AddressWatchOptions watch = {};
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
};

/// Pool of the replicas of one stage. It has one channel to each address of the names; the
/// addresses of a name may change at any time. A call goes to the reachable replica with the fewest
/// calls in flight. Thread-safe.
class StagePool : public ReplicaSource {
 public:
  /// Creates a pool. `stage`: name of the stage in messages. `names`: host:port; each name may have
  /// any number of addresses.
  StagePool(std::string stage, std::vector<std::string> names, rpc::JsonLog log,
            const StagePoolOptions& options = {});
  ~StagePool() override;

  /// Makes a call on a replica. Errors: errors of `attempt`; Unavailable if no replica was
  /// reachable within `connect_patience`.
  absl::Status Call(const CancelToken& cancel, const Attempt& attempt) override;

  /// Waits until a replica is reachable, for at most `patience`. Returns true if a replica is
  /// reachable.
  bool AwaitReady(std::chrono::milliseconds patience);

  /// Returns true if no replica can be reached: each channel tries to connect. A channel that has
  /// had no call for long is not tested.
  bool IsAway() const;

  /// Requests the build of each reachable replica. Returns false if at least one replica answers,
  /// and each one that answers is of another build or about to stop. Takes one second if a replica
  /// does not answer.
  bool OfThisBuild();

  /// Returns the current addresses, reachable or not.
  std::vector<std::string> Addresses() const;

 private:
  struct Replica;
  using Members = std::vector<std::shared_ptr<Replica>>;  // shared: a call may outlive a membership
  class Use;

  void Update(const std::vector<std::string>& addresses);
  std::shared_ptr<Replica> Pick(const std::set<std::string>& tried);
  absl::StatusOr<std::shared_ptr<Replica>> AwaitPick(const CancelToken& cancel,
                                                     const std::set<std::string>& tried);
  void AwaitChange() const;
  void Failed(Replica& replica, const absl::Status& status);
  absl::Status NoneReachable() const;

  const std::string stage_;
  const std::vector<std::string> names_;
  const rpc::JsonLog log_;
  const StagePoolOptions options_;
  mutable std::mutex mutex_;
  mutable std::condition_variable updated_;  ///< notified when the replicas change
  Members replicas_;
  int64_t turn_ = 0;
  AddressWatch watch_;  ///< last member, because its thread uses the other members
};

}  // namespace slicefarm::coordinator
