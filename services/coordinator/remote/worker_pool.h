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

struct WorkerPoolOptions {
  RemoteOptions remote = {};
  AddressWatchOptions watch = {};
  std::chrono::milliseconds greet_every{5'000};
  /// How long one that does not answer is waited for.
  std::chrono::milliseconds greeting_patience{10'000};
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
};

/// The workers behind some names. Each joins the runners once it has told its build and its slots,
/// and leaves them when its address goes or nobody has answered there for a while; before that, it
/// may be down for some seconds (Runner::await_ready). Workers of another build do not join. All
/// are asked again and again who they are: one that was started anew may have other slots, or
/// another build, of which a range that it refuses tells as well.
class WorkerPool {
 public:
  /// `runners` must outlive the pool. `names`: host:port, each with any number of addresses.
  WorkerPool(RunnerSet& runners, std::vector<std::string> names, rpc::JsonLog log,
             const WorkerPoolOptions& options = {});
  /// The workers leave.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Addresses of the workers that have joined.
  std::vector<std::string> Joined() const;

 private:
  struct Greeting;
  struct Member;
  class Tasks;
  using MemberPtr =
      std::shared_ptr<Member>;  // shared with the calls in flight, which may outlive a membership

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
  std::unique_ptr<AddressWatch> watch_;  ///< the last member: its thread uses the others
};

}  // namespace slicefarm::coordinator
