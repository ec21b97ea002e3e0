#include "services/coordinator/algo/dispatch/dispatcher.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

/// Interval at which an idle slot searches for a slow range to start a second copy of. Execute
/// checks for cancellation of its job at the same interval.
constexpr std::chrono::milliseconds kPoll{20};
/// Longest time that one readiness check of a runner may block a slot.
constexpr std::chrono::milliseconds kReadyWait{200};

using Flag =
    std::shared_ptr<std::atomic<bool>>;  // shared by a call's token and the job that stops it

absl::Status PoisonedError(const TaskLabel& task, int tries, const std::string& runner,
                           const absl::Status& last) {
  std::map<std::string, std::string> metadata = {
      {"tries", absl::StrCat(tries)}, {"cause", std::string(ReasonName(DetailOf(last).reason))}};
  for (const auto& [name, number] : task.numbers) metadata[name] = absl::StrCat(number);
  return MakeError(absl::StatusCode::kInternal, Reason::kRangePoisoned,
                   absl::StrCat(task.text, " failed ", tries, " times, the last time on ", runner,
                                ": ", last.message()),
                   std::move(metadata));
}

}  // namespace

struct Dispatcher::Member {
  RunnerId id = 0;
  Runner runner;
  ProcessSet can;
  bool leaving = false;
  int threads_running = 0;
  std::vector<std::thread> threads;
};

struct Dispatcher::Job {
  const FanOut::JobId id;
  const StageCall& call;
  const std::span<const Task> tasks;
  const TakeResult& take;
  /// Fingerprints of first results, keyed by range; only for ranges that may get a second result.
  std::map<int32_t, size_t> prints = {};
  /// Calls in flight, including calls of runners that left.
  std::map<FanOut::Ticket, Flag> calls = {};
  size_t taken = 0;  ///< number of results taken
  int32_t weight_done = 0;
  int64_t program_bytes = 0;
  bool over = false;
  absl::Status status = absl::OkStatus();

  bool Whole() const { return taken == tasks.size(); }
};

/// Task that a slot is about to run, with its job and its stop flag.
struct Dispatcher::Assignment {
  Job* job = nullptr;
  FanOut::Grant grant;
  StageCall call;
  Flag stop;
};

Dispatcher::Dispatcher(const DispatcherOptions& options)
    : options_(options), fan_out_(options.scheduler) {}

Dispatcher::~Dispatcher() {
  {
    Lock lock(mutex_);
    stopping_ = true;
    for (auto& [id, member] : members_) left_.push_back(std::move(member));
    members_.clear();
  }
  work_.notify_all();
  for (const auto& member : left_) {
    for (std::thread& thread : member->threads) thread.join();
  }
}

RunnerId Dispatcher::Join(Runner runner) {
  Lock lock(mutex_);
  Reap();
  const RunnerId id = next_runner_++;
  auto& member = *(members_[id] = std::make_unique<Member>());
  member.id = id;
  member.can = runner.tasks->processes();
  member.runner = std::move(runner);
  member.threads_running = std::max(member.runner.slots, 1);
  for (int i = 0; i < member.threads_running; ++i) {
    member.threads.emplace_back([this, &member] { Serve(member); });
  }
  work_.notify_all();  // with company, slots look for slow ranges
  return id;
}

void Dispatcher::Leave(RunnerId id) {
  Lock lock(mutex_);
  const auto found = members_.find(id);
  if (found == members_.end()) return;
  found->second->leaving = true;
  left_.push_back(std::move(found->second));
  members_.erase(found);
  fan_out_.RunnerGone(id);
  Reap();
  work_.notify_all();
}

void Dispatcher::Refuse(const std::string& name, const std::string& why) {
  Lock lock(mutex_);
  refused_.erase(name);
  if (!why.empty()) refused_.emplace(name, why);
}

std::string Dispatcher::Refusal() const {
  Lock lock(mutex_);
  if (refused_.empty()) return "";
  return absl::StrCat(refused_.begin()->first, ": ", refused_.begin()->second);
}

/// Joins the threads of members that left and removes these members. Skips members with a running
/// thread.
void Dispatcher::Reap() {
  std::erase_if(left_, [](const std::unique_ptr<Member>& member) {
    if (member->threads_running > 0) return false;
    for (std::thread& thread : member->threads) thread.join();
    return true;
  });
}

int Dispatcher::Slots(Process process) const {
  Lock lock(mutex_);
  int slots = 0;
  for (const auto& [id, member] : members_)
    if (member->can.Has(process)) slots += std::max(member->runner.slots, 1);
  return slots;
}

DispatchCounts Dispatcher::Counts() const {
  Lock lock(mutex_);
  return fan_out_.Counts();
}

absl::Status Dispatcher::Execute(const StageCall& call, std::span<const Task> tasks,
                                 const TakeResult& take,
                                 const std::function<void(int32_t)>& weight_done) {
  if (tasks.empty()) return absl::OkStatus();
  Lock lock(mutex_);
  const Process process = tasks.front().process();
  Job job{fan_out_.Add(static_cast<int32_t>(tasks.size()), process, call.claimant), call, tasks,
          take};
  jobs_[job.id] = &job;
  work_.notify_all();
  int32_t reported = 0;
  while (!job.over && (!job.Whole() || reported < job.weight_done)) {
    if (reported == job.weight_done) AwaitEnd(lock, job);
    if (reported == job.weight_done) continue;
    reported = job.weight_done;
    lock.unlock();
    if (weight_done) weight_done(reported);
    lock.lock();
  }
  fan_out_.Remove(job.id);
  jobs_.erase(job.id);
  // The caller owns the tasks, so every call must end before Execute returns.
  for (const auto& [ticket, stop] : job.calls) stop->store(true);
  changed_.wait(lock, [&] { return job.calls.empty(); });
  return job.status;
}

/// Waits for a change of the job, for at most kPoll. Ends the job if its call was cancelled.
void Dispatcher::AwaitEnd(Lock& lock, Job& job) {
  changed_.wait_for(lock, kPoll);
  if (job.over || job.Whole()) return;
  lock.unlock();
  absl::Status wanted = job.call.cancel.Check();
  lock.lock();
  if (!wanted.ok()) End(job, std::move(wanted));
}

/// Runs tasks on one slot of the member until the member leaves or the dispatcher stops.
void Dispatcher::Serve(Member& member) {
  Lock lock(mutex_);
  int failures = 0;
  while (AwaitWork(lock, member)) {
    if (!Ready(lock, member)) {
      Rest(lock, member, /*failures=*/1);
      continue;
    }
    std::optional<Assignment> assignment = Take(member);
    if (!assignment) continue;
    const Task& task = assignment->job->tasks[assignment->grant.range];
    lock.unlock();
    auto result = member.runner.tasks->RunTask(assignment->call, task);
    const absl::Status wanted = assignment->call.cancel.Check();
    const bool failed = !result.ok() && wanted.ok();
    lock.lock();
    Report(lock, member, *assignment, wanted, std::move(result));
    assignment.reset();
    failures = failed ? failures + 1 : 0;
    if (failed) Rest(lock, member, failures);
  }
  --member.threads_running;
}

/// Waits until a job has work for the slot. Returns false if the member leaves or the dispatcher
/// stops.
bool Dispatcher::AwaitWork(Lock& lock, Member& member) {
  const auto ended = [&] { return stopping_ || member.leaving; };
  while (!ended()) {
    if (fan_out_.MayTake(member.id, clock_.Seconds(), member.can)) return true;
    if (jobs_.empty() || (members_.size() < 2 && !fan_out_.AnySuspects())) {
      work_.wait(lock);
    } else if (work_.wait_for(lock, kPoll) == std::cv_status::timeout) {
      return !ended();  // time to look for a slow range
    }
  }
  return false;
}

/// Returns true if the runner can be reached. Waits for this for at most kReadyWait.
bool Dispatcher::Ready(Lock& lock, const Member& member) {
  if (!member.runner.await_ready) return true;
  lock.unlock();
  const bool ready = member.runner.await_ready(kReadyWait);
  lock.lock();
  return ready && !stopping_ && !member.leaving;
}

void Dispatcher::Rest(Lock& lock, const Member& member, int failures) {
  const auto rest = RestAfter(failures, options_.min_rest, options_.max_rest);
  work_.wait_for(lock, rest, [&] { return stopping_ || member.leaving; });
}

std::optional<Dispatcher::Assignment> Dispatcher::Take(Member& member) {
  const auto grant = fan_out_.Take(member.id, clock_.Seconds(), member.can);
  if (!grant) return std::nullopt;
  Job& job = *jobs_.at(grant->job);
  Assignment assignment{&job, *grant, job.call, std::make_shared<std::atomic<bool>>(false)};
  assignment.call.threads = 1;
  assignment.call.cancel = CancelToken([stop = assignment.stop, wanted = job.call.cancel] {
    return stop->load() || wanted.Cancelled();
  });
  job.calls.emplace(grant->ticket, assignment.stop);
  return assignment;
}

/// Applies the result of one call to its job. `wanted` is an error if the job or this copy of the
/// range was cancelled during the call. The job exists until its last call in flight is removed.
void Dispatcher::Report(Lock& lock, const Member& member, const Assignment& assignment,
                        const absl::Status& wanted, absl::StatusOr<TaskResult> result) {
  Job& job = *assignment.job;
  fan_out_.Returned(assignment.grant);
  if (assignment.grant.alone) work_.notify_all();
  if (job.over) {
    // The job is over, so the result is dropped.
  } else if (result.ok()) {
    Accept(lock, assignment, *std::move(result));
  } else if (wanted.ok()) {
    Reject(job, member, assignment, result.status());
  } else if (assignment.stop->load()) {
    fan_out_.Superseded(assignment.grant);
  } else {
    End(job, wanted);
  }
  job.calls.erase(assignment.grant.ticket);
  changed_.notify_all();
}

/// Passes the first result of a range to the job. Stores the result's fingerprint if a second copy
/// still runs, to compare the two results later.
void Dispatcher::Accept(Lock& lock, const Assignment& assignment, TaskResult result) {
  Job& job = *assignment.job;
  const int32_t range = assignment.grant.range;
  const auto accepted = fan_out_.Succeeded(assignment.grant, clock_.Seconds());
  if (!accepted.first) {
    const auto first = job.prints.find(range);
    if (first != job.prints.end() && first->second != result.Print()) fan_out_.Differed();
    return;
  }
  for (const FanOut::Ticket ticket : accepted.superfluous) {
    if (const auto call = job.calls.find(ticket); call != job.calls.end())
      call->second->store(true);
  }
  if (!accepted.superfluous.empty()) job.prints[range] = result.Print();
  job.program_bytes += result.ProgramBytes();
  if (job.program_bytes > options_.most_program_bytes)
    return End(job, LimitError(Reason::kRequestTooLarge, "bytes of the job's program",
                               options_.most_program_bytes, job.program_bytes));
  lock.unlock();
  absl::Status taken = job.take(static_cast<size_t>(range), std::move(result));
  lock.lock();
  if (job.over) return;
  if (!taken.ok()) return End(job, std::move(taken));
  ++job.taken;
  job.weight_done += job.tasks[range].weight();
}

void Dispatcher::Reject(Job& job, const Member& member, const Assignment& assignment,
                        const absl::Status& error) {
  const int32_t range = assignment.grant.range;
  switch (fan_out_.Failed(assignment.grant, error)) {
    case FanOut::Verdict::kGoesOn:
      work_.notify_all();
      return;
    case FanOut::Verdict::kInputAtFault:
      return End(job, error);
    case FanOut::Verdict::kPoisoned:
      return End(job, PoisonedError(job.tasks[range].label(), fan_out_.Tries(job.id, range),
                                    member.runner.name, error));
  }
}

void Dispatcher::End(Job& job, absl::Status status) {
  job.over = true;
  job.status = std::move(status);
  fan_out_.Remove(job.id);
}

}  // namespace slicefarm::coordinator
