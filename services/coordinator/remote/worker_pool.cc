#include "services/coordinator/remote/worker_pool.h"

#include <grpcpp/alarm.h>
#include <grpcpp/client_context.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "common/base/build_info.h"
#include "common/base/error.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/remote/remote_worker.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

using std::chrono::milliseconds;
using std::chrono::system_clock;

constexpr milliseconds kRetryDelay{100};

/// Returns the processes of the worker that this build supports.
ProcessSet ProcessesOf(const v1::WorkerInfo& info) {
  ProcessSet processes;
  for (const int process : info.processes())
    if (process >= 1 && process <= kProcessCount) processes.Add(static_cast<Process>(process - 1));
  return processes;
}

absl::Status CheckInfo(const v1::WorkerInfo& info) {
  if (info.build_id() != BuildId()) {
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
                     "the worker is of build " + info.build_id() + ", the coordinator of build " +
                         std::string(BuildId()));
  }
  if (ProcessesOf(info).empty()) {
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     "the worker supports no process");
  }
  if (info.slots() < 1) {
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal, "the worker has no slots");
  }
  return absl::OkStatus();
}

}  // namespace

/// Delayed request for a worker's info. It owns itself, because gRPC calls back with the bare
/// pointer.
struct WorkerPool::Greeting {
  MemberPtr member;
  std::shared_ptr<Greeting> self;  ///< owns this object until the greeting ends
  grpc::Alarm delay;
  grpc::ClientContext context;
  v1::GetWorkerInfoRequest request;
  v1::WorkerInfo info;
};

struct WorkerPool::Member {
  Member(std::string where, const WorkerPoolOptions& options)
      : address(std::move(where)),
        replica(rpc::MakeChannel(address, {.credentials = options.credentials})),
        worker(replica, options.remote) {}

  const std::string address;
  SingleReplica replica;
  const RemoteWorker worker;
  std::mutex pool_mutex;       ///< held while a call in flight uses the pool
  WorkerPool* pool = nullptr;  ///< null if the pool may have been destroyed
  // The pool's mutex protects the following members:
  std::weak_ptr<Greeting> greeting;
  int greetings = 0;    ///< number of greetings that have not ended
  RunnerId runner = 0;  ///< 0: has not joined
  int slots = 0;        ///< slots of that runner
  ProcessSet processes;
  bool dismissed = false;
};

/// Task runner of a worker that has joined. If the worker turns out to be of another build, the
/// worker leaves, once.
class WorkerPool::Tasks : public TaskRunner {
 public:
  Tasks(MemberPtr member, ProcessSet processes, rpc::JsonLog log)
      : member_(std::move(member)), processes_(processes), log_(std::move(log)) {}

  ProcessSet processes() const override { return processes_; }

  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override {
    auto result = member_->worker.RunTask(call, task);
    if (IsReplicasFault(result.status())) {
      rpc::LogFields fields = {{"address", member_->address},
                               {"job", call.job_id},
                               {"error", std::string(result.status().message())}};
      for (const auto& [name, number] : task.label().numbers) fields.push_back({name, number});
      log_.Warn("worker failed", fields);
    }
    if (DetailOf(result.status()).reason != Reason::kBuildMismatch || misfit_.exchange(true)) {
      return result;
    }
    const std::lock_guard lock(member_->pool_mutex);
    if (member_->pool != nullptr) member_->pool->Leave(member_, "it is of another build");
    return result;
  }

 private:
  const MemberPtr member_;
  const ProcessSet processes_;
  const rpc::JsonLog log_;
  mutable std::atomic<bool> misfit_ = false;
};

WorkerPool::WorkerPool(RunnerSet& runners, std::vector<std::string> names, rpc::JsonLog log,
                       const WorkerPoolOptions& options)
    : runners_(runners),
      log_(std::move(log)),
      options_(options),
      watch_(std::make_unique<AddressWatch>(
          std::move(names), [this](const auto& addresses) { Update(addresses); }, options_.watch)) {
}

WorkerPool::~WorkerPool() {
  watch_.reset();
  Update({});
}

void WorkerPool::Update(const std::vector<std::string>& addresses) {
  std::vector<MemberPtr> joining;
  std::vector<MemberPtr> leaving;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [address, member] : members_) {
      if (!std::ranges::binary_search(addresses, address)) leaving.push_back(member);
    }
    for (const MemberPtr& member : leaving) members_.erase(member->address);
    for (const std::string& address : addresses) {
      if (members_.contains(address)) continue;
      joining.push_back(std::make_shared<Member>(address, options_));
      joining.back()->pool = this;
      members_[address] = joining.back();
    }
  }
  for (const MemberPtr& member : leaving) Dismiss(member);
  for (const MemberPtr& member : joining) Greet(member, milliseconds(0));
}

/// Ends the membership and waits for the end of its greetings. In gRPC 1.51, a callback must not
/// drop the last reference to a channel that makes callback calls. The last such channel ends the
/// callback thread, and the thread would then have to join itself.
void WorkerPool::Dismiss(const MemberPtr& member) {
  {
    const std::lock_guard lock(member->pool_mutex);
    member->pool = nullptr;
  }
  {
    const std::lock_guard lock(mutex_);
    member->dismissed = true;
    if (const auto greeting = member->greeting.lock()) {
      greeting->delay.Cancel();
      greeting->context.TryCancel();
    }
  }
  Leave(member, "its address does not exist any more");
  std::unique_lock lock(mutex_);
  greeted_.wait(lock, [&] { return member->greetings == 0; });
  lock.unlock();
  runners_.Refuse(member->address, "");
}

void WorkerPool::Greet(const MemberPtr& member, milliseconds delay) {
  const std::lock_guard lock(mutex_);
  if (member->dismissed) return;
  const auto greeting = std::make_shared<Greeting>();
  greeting->member = member;
  greeting->self = greeting;
  member->greeting = greeting;
  ++member->greetings;
  greeting->delay.Set(system_clock::now() + delay, [this, &greeting = *greeting](bool in_time) {
    in_time ? Ask(greeting) : End(greeting);
  });
}

void WorkerPool::Ask(Greeting& greeting) {
  greeting.context.set_wait_for_ready(true);
  greeting.context.set_deadline(system_clock::now() + options_.greeting_patience);
  const auto stub = v1::Worker::NewStub(greeting.member->replica.channel());
  stub->async()->GetWorkerInfo(&greeting.context, &greeting.request, &greeting.info,
                               [this, &greeting](const grpc::Status& status) {
                                 Hear(greeting.member, rpc::FromGrpc(status), greeting.info);
                                 End(greeting);
                               });
}

void WorkerPool::Hear(const MemberPtr& member, const absl::Status& status,
                      const v1::WorkerInfo& info) {
  const absl::Status fit = status.ok() ? CheckInfo(info) : status;
  const bool absent = absl::IsDeadlineExceeded(status) || absl::IsUnavailable(status);
  const bool refused = !fit.ok() && !absent && !absl::IsCancelled(status);
  const std::string why = refused ? std::string(fit.message()) : "";
  if (refused) log_.Warn("worker refused", {{"address", member->address}, {"error", why}});
  runners_.Refuse(member->address, why);
  if (status.ok()) Seat(member, fit.ok() ? info.slots() : 0, ProcessesOf(info));
  if (absl::IsDeadlineExceeded(status)) Leave(member, "it does not answer");
  Greet(member, absent ? kRetryDelay : options_.greet_every);
}

/// Makes the member a runner with `slots` slots. If its slots or processes changed, it leaves and
/// joins again; with 0 slots it only leaves.
void WorkerPool::Seat(const MemberPtr& member, int slots, ProcessSet processes) {
  {
    const std::lock_guard lock(mutex_);
    if (member->runner != 0 && member->slots == slots && member->processes == processes) return;
  }
  Leave(member, "another worker was started at its address");
  if (slots == 0) return;
  Runner runner;
  runner.name = member->address;
  runner.tasks = std::make_shared<Tasks>(member, processes, log_);
  runner.slots = slots;
  runner.await_ready = [channel = member->replica.channel()](milliseconds patience) {
    return channel->WaitForConnected(system_clock::now() + patience);
  };
  const std::lock_guard lock(mutex_);
  if (member->dismissed) return;
  member->runner = runners_.Join(std::move(runner));
  member->slots = slots;
  member->processes = processes;
  log_.Info("worker joined", {{"address", member->address}, {"slots", int64_t{slots}}});
}

/// Removes the member from the runners, if it has joined.
void WorkerPool::Leave(const MemberPtr& member, std::string_view why) {
  RunnerId runner = 0;
  {
    const std::lock_guard lock(mutex_);
    std::swap(runner, member->runner);
  }
  if (runner == 0) return;
  runners_.Leave(runner);
  log_.Info("worker left", {{"address", member->address}, {"why", std::string(why)}});
}

void WorkerPool::End(Greeting& greeting) {
  Member& member = *greeting.member;  // Dismiss keeps the member until all its greetings have ended
  std::exchange(greeting.self, nullptr).reset();
  const std::lock_guard lock(mutex_);
  --member.greetings;
  greeted_.notify_all();
}

std::vector<std::string> WorkerPool::Joined() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> addresses;
  for (const auto& [address, member] : members_) {
    if (member->runner != 0) addresses.push_back(address);
  }
  return addresses;
}

}  // namespace slicefarm::coordinator
