#include "services/coordinator/algo/dispatcher.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/model/error.h"

namespace slicefarm::coordinator {
namespace {

/// How often an idle slot looks for a slow range to double, and Execute asks whether its job is
/// still wanted.
constexpr std::chrono::milliseconds kPoll{20};
/// How long a slot waits at a time for its runner to be reachable.
constexpr std::chrono::milliseconds kReadyWait{200};

using Flag =
    std::shared_ptr<std::atomic<bool>>;  // shared by a call's token and the job that stops it

/// True if the input is at fault: the same anywhere, whatever the number of tries.
bool IsFinal(const absl::Status& status) {
  return absl::IsInvalidArgument(status) || absl::IsOutOfRange(status);
}

absl::Status PoisonedError(const LayerRange& range, int tries, const std::string& runner,
                           const absl::Status& last) {
  return MakeError(absl::StatusCode::kInternal, Reason::kRangePoisoned,
                   absl::StrCat("layers ", range.first, " to ", range.last - 1, " failed ", tries,
                                " times, the last time on ", runner, ": ", last.message()),
                   {{"layer_first", absl::StrCat(range.first)},
                    {"layer_last", absl::StrCat(range.last - 1)},
                    {"tries", absl::StrCat(tries)},
                    {"cause", std::string(ReasonName(DetailOf(last).reason))}});
}

}  // namespace

struct Dispatcher::Member {
  RunnerId id = 0;
  Runner runner;
  bool leaving = false;
  int threads_running = 0;
  std::vector<std::thread> threads;
};

struct Dispatcher::Job {
  Job(const StageCall& stage_call, std::span<const RangeTask> range_tasks,
      const SchedulerOptions& options)
      : call(stage_call),
        tasks(range_tasks),
        scheduler(static_cast<int32_t>(range_tasks.size()), options),
        results(range_tasks.size()) {}

  const StageCall& call;
  const std::span<const RangeTask> tasks;
  RangeScheduler scheduler;
  std::vector<RangeResult> results;
  std::map<RangeScheduler::Ticket, Flag> calls;  ///< in flight, those of runners that left included
  int32_t layers_done = 0;
  int64_t last_turn = 0;
  bool over = false;
  absl::Status status;
};

/// What a slot is to do next.
struct Dispatcher::Assignment {
  Job* job = nullptr;
  RangeScheduler::Grant grant;
  StageCall call;
  Flag stop;
};

Dispatcher::Dispatcher(const DispatcherOptions& options) : options_(options) {}

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
  for (Job* job : jobs_) job->scheduler.RunnerGone(id);
  Reap();
  work_.notify_all();
}

/// Joins the threads of members that left and have come to their end.
void Dispatcher::Reap() {
  std::erase_if(left_, [](const std::unique_ptr<Member>& member) {
    if (member->threads_running > 0) return false;
    for (std::thread& thread : member->threads) thread.join();
    return true;
  });
}

int Dispatcher::Slots() const {
  Lock lock(mutex_);
  int slots = 0;
  for (const auto& [id, member] : members_) slots += std::max(member->runner.slots, 1);
  return slots;
}

DispatchCounts Dispatcher::Counts() const {
  Lock lock(mutex_);
  DispatchCounts counts = counts_;
  for (const Job* job : jobs_) {
    counts.requeued += job->scheduler.Requeued();
    counts.hedged += job->scheduler.Hedged();
  }
  return counts;
}

absl::StatusOr<std::vector<RangeResult>> Dispatcher::Execute(
    const StageCall& call, std::span<const RangeTask> tasks,
    const std::function<void(int32_t)>& layers_done) {
  Job job(call, tasks, options_.scheduler);
  Lock lock(mutex_);
  jobs_.push_back(&job);
  work_.notify_all();
  int32_t told = 0;
  while (!job.over && (!job.scheduler.AllDone() || told < job.layers_done)) {
    if (told == job.layers_done) AwaitEnd(lock, job);
    if (told == job.layers_done) continue;
    told = job.layers_done;
    lock.unlock();
    if (layers_done) layers_done(told);
    lock.lock();
  }
  jobs_.remove(&job);
  counts_.requeued += job.scheduler.Requeued();
  counts_.hedged += job.scheduler.Hedged();
  // The tasks are the caller's: every call has to be over before they may go.
  for (const auto& [ticket, stop] : job.calls) stop->store(true);
  changed_.wait(lock, [&] { return job.calls.empty(); });
  if (!job.status.ok()) return job.status;
  return std::move(job.results);
}

/// Returns when something about the job may have changed.
void Dispatcher::AwaitEnd(Lock& lock, Job& job) {
  changed_.wait_for(lock, kPoll);
  if (job.over || job.scheduler.AllDone()) return;
  lock.unlock();
  absl::Status wanted = job.call.cancel.Check();
  lock.lock();
  if (!wanted.ok()) End(job, std::move(wanted));
}

/// The life of one slot.
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
    const RangeTask& task = assignment->job->tasks[assignment->grant.range];
    lock.unlock();
    auto result = member.runner.ranges->Run(assignment->call, task);
    const absl::Status wanted = assignment->call.cancel.Check();
    const bool failed = !result.ok() && wanted.ok();
    lock.lock();
    Report(member, *assignment, wanted, std::move(result));
    assignment.reset();
    failures = failed ? failures + 1 : 0;
    if (failed) Rest(lock, member, failures);
  }
  --member.threads_running;
}

/// Waits until a job wants something done; false: the slot's time is over.
bool Dispatcher::AwaitWork(Lock& lock, Member& member) {
  const auto ended = [&] { return stopping_ || member.leaving; };
  while (!ended()) {
    const bool queued = std::any_of(jobs_.begin(), jobs_.end(), [](const Job* job) {
      return !job->over && job->scheduler.Queued() > 0;
    });
    if (queued) return true;
    if (jobs_.empty() || members_.size() < 2) {
      work_.wait(lock);
    } else if (work_.wait_for(lock, kPoll) == std::cv_status::timeout) {
      return !ended();  // time to look for a slow range
    }
  }
  return false;
}

/// Asks the runner whether it can be reached.
bool Dispatcher::Ready(Lock& lock, const Member& member) {
  if (!member.runner.await_ready) return true;
  lock.unlock();
  const bool ready = member.runner.await_ready(kReadyWait);
  lock.lock();
  return ready && !stopping_ && !member.leaving;
}

void Dispatcher::Rest(Lock& lock, const Member& member, int failures) {
  const auto rest =
      std::min(options_.max_rest, options_.min_rest * (1 << std::min(failures - 1, 10)));
  work_.wait_for(lock, rest, [&] { return stopping_ || member.leaving; });
}

/// From the job with the fewest ranges in flight, of these from the one that has waited longest. A
/// slow range is doubled only when nothing is queued.
std::optional<Dispatcher::Assignment> Dispatcher::Take(Member& member) {
  std::vector<Job*> jobs;
  std::copy_if(jobs_.begin(), jobs_.end(), std::back_inserter(jobs),
               [](Job* job) { return !job->over; });
  std::stable_sort(jobs.begin(), jobs.end(), [](const Job* a, const Job* b) {
    return std::pair(a->scheduler.Running(), a->last_turn) <
           std::pair(b->scheduler.Running(), b->last_turn);
  });
  const double now_s = clock_.Seconds();
  for (Job* job : jobs) {
    if (const auto grant = job->scheduler.Next(member.id, now_s)) return Assign(*job, *grant);
  }
  for (Job* job : jobs) {
    if (const auto grant = job->scheduler.Hedge(member.id, now_s)) return Assign(*job, *grant);
  }
  return std::nullopt;
}

Dispatcher::Assignment Dispatcher::Assign(Job& job, const RangeScheduler::Grant& grant) {
  job.last_turn = next_turn_++;
  Assignment assignment{&job, grant, job.call, std::make_shared<std::atomic<bool>>(false)};
  assignment.call.threads = 1;
  assignment.call.cancel = CancelToken([stop = assignment.stop, wanted = job.call.cancel] {
    return stop->load() || wanted.Cancelled();
  });
  job.calls.emplace(grant.ticket, assignment.stop);
  return assignment;
}

/// `wanted`: not OK if the job or this copy of the range was cancelled meanwhile.
void Dispatcher::Report(const Member& member, const Assignment& assignment,
                        const absl::Status& wanted, absl::StatusOr<RangeResult> result) {
  Job& job = *assignment.job;
  job.calls.erase(assignment.grant.ticket);
  if (job.over) {
    // Nothing is wanted of it any more.
  } else if (result.ok()) {
    Accept(job, assignment, *std::move(result));
  } else if (wanted.ok()) {
    Reject(job, member, assignment, result.status());
  } else if (assignment.stop->load()) {
    job.scheduler.Failed(assignment.grant.ticket);  // another copy made it
  } else {
    End(job, wanted);
  }
  changed_.notify_all();
}

void Dispatcher::Accept(Job& job, const Assignment& assignment, RangeResult result) {
  const auto accepted = job.scheduler.Succeeded(assignment.grant.ticket, clock_.Seconds());
  if (!accepted.first) return;
  for (const RangeScheduler::Ticket ticket : accepted.superfluous) {
    if (const auto call = job.calls.find(ticket); call != job.calls.end())
      call->second->store(true);
  }
  const int32_t range = assignment.grant.range;
  job.results[range] = std::move(result);
  job.layers_done += job.tasks[range].range.size();
  ++counts_.done;
}

void Dispatcher::Reject(Job& job, const Member& member, const Assignment& assignment,
                        const absl::Status& error) {
  if (IsFinal(error)) return End(job, error);
  if (DetailOf(error).reason == Reason::kBuildMismatch) {
    job.scheduler.Abandoned(assignment.grant.ticket);  // says nothing of the range
    work_.notify_all();
    return;
  }
  const int32_t range = assignment.grant.range;
  job.scheduler.Failed(assignment.grant.ticket);
  if (job.scheduler.Poisoned() == range) {
    ++counts_.poisoned;
    return End(job, PoisonedError(job.tasks[range].range, job.scheduler.Tries(range),
                                  member.runner.name, error));
  }
  work_.notify_all();
}

void Dispatcher::End(Job& job, absl::Status status) {
  job.over = true;
  job.status = std::move(status);
}

}  // namespace slicefarm::coordinator
