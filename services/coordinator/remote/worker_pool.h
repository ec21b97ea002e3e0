#pragma once

#include <grpcpp/security/credentials.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/algo/dispatch/runner_set.h"
#include "services/coordinator/remote/address_watch.h"
#include "services/coordinator/remote/remote_call.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm::coordinator {

/// Options of a WorkerPool.
struct WorkerPoolOptions {
  RemoteOptions remote = {};
  AddressWatchOptions watch = {};
  std::chrono::milliseconds greet_every{5'000};
  /// Longest wait for a worker's answer to a request for its info.
  std::chrono::milliseconds greeting_patience{10'000};
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
};

/// Pool of workers. It finds their addresses by looking up the given host names (`names`). The pool
/// adds a worker to the given RunnerSet when the worker has reported its build and its slots. It
/// removes a worker when its address disappears, or when the worker does not answer a request
/// within `greeting_patience`. Interruptions of some seconds are allowed (Runner::await_ready).
/// Workers of another build are not added.
///
/// The pool requests the info of all workers at regular intervals, because a restarted worker may
/// have other slots or another build. BUILD_MISMATCH as the answer to a range also shows that a
/// worker is of another build.
class WorkerPool {
 public:
  /// Adds the workers to `runners`, which must outlive the pool. `names`: HOST:PORT; the lookup of
  /// each name may give any number of addresses.
  WorkerPool(RunnerSet& runners, std::vector<std::string> names, rpc::JsonLog log,
             const WorkerPoolOptions& options = {});
  /// Removes all workers from the runners.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Returns the addresses of the workers that have joined.
  std::vector<std::string> Joined() const;

 private:
  struct Greeting;
  struct Member;
  class Tasks;
  using MemberPtr =
      std::shared_ptr<Member>;  // shared with calls in flight, which may outlive a membership

  void Update(const std::vector<std::string>& addresses);
  void Greet(const MemberPtr& member, std::chrono::milliseconds delay);
  void Ask(Greeting& greeting);
  void Hear(const MemberPtr& member, const absl::Status& status, const v1::WorkerInfo& info);
  void Seat(const MemberPtr& member, int slots, ProcessSet processes);
  void Leave(const MemberPtr& member, std::string_view why);
  void Dismiss(const MemberPtr& member);
  void End(Greeting& greeting);

  RunnerSet& runners_;
  const rpc::JsonLog log_;
  const WorkerPoolOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable greeted_;
  std::map<std::string, MemberPtr> members_;
  std::unique_ptr<AddressWatch> watch_;  ///< last member, because its thread uses the other members
};

}  // namespace slicefarm::coordinator
