#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "common/base/stopwatch.h"
#include "common/model/limits.h"
#include "services/coordinator/algo/dispatch/fan_out.h"
#include "services/coordinator/algo/dispatch/runner_set.h"
#include "services/coordinator/algo/dispatch/task_executor.h"

namespace slicefarm::coordinator {

struct DispatcherOptions {
  SchedulerOptions scheduler;
  /// A slot whose call failed rests this long, twice as long each further time, up to the maximum.
  std::chrono::milliseconds min_rest{20};
  std::chrono::milliseconds max_rest{1000};
  /// A job whose results come to more ends.
  int64_t most_program_bytes = limits::kMaxProgramBytes;
};

/// Runs the ranges of any number of jobs over the runners there are, as FanOut decides. One thread
/// a slot: a runner gets a range when it has answered one, so a fast runner gets more.
///
/// A runner gets tasks of its processes only.
///
/// Errors: a stage's own where it says that the input is at fault (INVALID_ARGUMENT, OUT_OF_RANGE);
/// RANGE_POISONED with the label of a task that failed too often; REQUEST_TOO_LARGE where the
/// results come to more bytes than a program may have; CANCELLED. BUILD_MISMATCH is
/// the runner's fault and no try of the range. With no runner for their process, Execute waits for
/// one to join. Thread-safe. REQUIRES: no Execute runs any more when it is destroyed.
class Dispatcher : public TaskExecutor, public RunnerSet {
 public:
  explicit Dispatcher(const DispatcherOptions& options = {});
  ~Dispatcher() override;

  RunnerId Join(Runner runner) override;
  void Leave(RunnerId id) override;

  absl::Status Execute(const StageCall& call, std::span<const Task> tasks, const TakeResult& take,
                       const std::function<void(int32_t)>& weight_done) override;
  int Slots(Process process) const override;

  DispatchCounts Counts() const;

 private:
  using Lock = std::unique_lock<std::mutex>;
  struct Member;
  struct Job;
  struct Assignment;

  void Serve(Member& member);
  bool AwaitWork(Lock& lock, Member& member);
  void Rest(Lock& lock, const Member& member, int failures);
  bool Ready(Lock& lock, const Member& member);
  std::optional<Assignment> Take(Member& member);
  void Report(Lock& lock, const Member& member, const Assignment& assignment,
              const absl::Status& wanted, absl::StatusOr<TaskResult> result);
  void Accept(Lock& lock, const Assignment& assignment, TaskResult result);
  void Reject(Job& job, const Member& member, const Assignment& assignment,
              const absl::Status& error);
  void End(Job& job, absl::Status status);
  void AwaitEnd(Lock& lock, Job& job);
  void Reap();

  const DispatcherOptions options_;
  const Stopwatch clock_;
  mutable std::mutex mutex_;
  std::condition_variable work_;     ///< there may be something to do for a slot, or it is to end
  std::condition_variable changed_;  ///< a job may have got on or be over
  FanOut fan_out_;
  std::map<FanOut::JobId, Job*> jobs_;  ///< they live on the stacks of Execute
  std::map<RunnerId, std::unique_ptr<Member>> members_;
  std::vector<std::unique_ptr<Member>> left_;  ///< members that left, whose threads may still run
  RunnerId next_runner_ = 1;
  bool stopping_ = false;
};

}  // namespace slicefarm::coordinator
