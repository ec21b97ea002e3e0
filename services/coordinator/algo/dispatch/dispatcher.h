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

/// Options of a Dispatcher.
struct DispatcherOptions {
  SchedulerOptions scheduler;
  /// Pause of a slot after a failed call. Each further failure in a row doubles the pause, up to
  /// `max_rest`.
  std::chrono::milliseconds min_rest{20};
  std::chrono::milliseconds max_rest{1000};
  /// Largest total size of a job's results, in bytes. A larger job ends with an error.
  int64_t most_program_bytes = limits::kMaxProgramBytes;
};

/// Runs the ranges of any number of jobs on the runners that have joined. FanOut decides the order
/// of the ranges. Each slot of a runner has one thread, which takes the next range when it has
/// finished one. So a fast runner gets more ranges. A runner gets only tasks of the processes that
/// it supports.
///
/// Errors of Execute: the stage's error if the input is at fault (INVALID_ARGUMENT, OUT_OF_RANGE);
/// RANGE_POISONED with the label of a task that failed too often; REQUEST_TOO_LARGE if the results
/// have more than `most_program_bytes`; CANCELLED. BUILD_MISMATCH is the runner's fault and does
/// not count as a try of the range. If no runner supports the process, Execute waits until one
/// joins. Thread-safe. REQUIRES: no Execute is running at destruction.
class Dispatcher : public TaskExecutor, public RunnerSet {
 public:
  explicit Dispatcher(const DispatcherOptions& options = {});
  ~Dispatcher() override;

  RunnerId Join(Runner runner) override;
  void Leave(RunnerId id) override;
  void Refuse(const std::string& name, const std::string& why) override;

  absl::Status Execute(const StageCall& call, std::span<const Task> tasks, const TakeResult& take,
                       const std::function<void(int32_t)>& weight_done) override;
  int Slots(Process process) const override;
  std::string Refusal() const override;

  /// Returns the counts of range outcomes since the start of this object.
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
  std::condition_variable work_;     ///< notified when a slot may have work or must end
  std::condition_variable changed_;  ///< notified when a job may have progressed or ended
  FanOut fan_out_;
  /// Running jobs. Each Job object is on the stack of its Execute call.
  std::map<FanOut::JobId, Job*> jobs_;
  std::map<RunnerId, std::unique_ptr<Member>> members_;
  /// Runners that left but may still have running threads.
  std::vector<std::unique_ptr<Member>> left_;
  std::map<std::string, std::string> refused_;  ///< name of a runner that may not join -> why
  RunnerId next_runner_ = 1;
  bool stopping_ = false;
};

}  // namespace slicefarm::coordinator
