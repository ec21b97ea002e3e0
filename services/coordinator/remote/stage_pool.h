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

struct StagePoolOptions {
  int tries = 3;  ///< of one call, on different replicas as far as there are
  /// Of these, on replicas that began with it and were not heard of any more: they may have died of
  /// it.
  int lost_tries = 2;
  /// How long a replica that failed is passed over while another one is there.
  std::chrono::milliseconds rest{1'000};
  /// How long a call waits for any replica to be reachable: longer than one takes to start again.
  std::chrono::milliseconds connect_patience{15'000};
  AddressWatchOptions watch = {};
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
};

/// The replicas of one stage: one channel to each address behind the names, which may change at any
/// time. A call goes to the reachable replica with the fewest calls in flight. Thread-safe.
class StagePool : public ReplicaSource {
 public:
  /// `stage`: what messages call it. `names`: host:port, each with any number of addresses.
  StagePool(std::string stage, std::vector<std::string> names, rpc::JsonLog log,
            const StagePoolOptions& options = {});
  ~StagePool() override;

  /// Errors, besides the attempt's: Unavailable if no replica could be reached in time.
  absl::Status Call(const CancelToken& cancel, const Attempt& attempt) override;

  /// Waits until a replica can be reached, at most for the given time; tells whether one can.
  bool AwaitReady(std::chrono::milliseconds patience);

  /// Asks the replicas that can be reached who they are. False: those that answer are all of
  /// another build, or about to stop. Takes a second if one does not answer.
  bool OfThisBuild();

  /// The addresses at the moment, reachable or not.
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
  mutable std::condition_variable updated_;  ///< there are other replicas
  Members replicas_;
  int64_t turn_ = 0;
  AddressWatch watch_;  ///< the last member: its thread uses the others
};

}  // namespace slicefarm::coordinator
