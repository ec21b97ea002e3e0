#include "services/coordinator/algo/dispatch/fleet.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"

namespace slicefarm::coordinator {
namespace {

/// Longest error text in a span, in bytes. This much shows the cause of the error, and a job may
/// have thousands of spans.
constexpr size_t kMaxErrorBytes = 200;

void NoteOutcome(const absl::StatusOr<TaskResult>& result, ScopedSpan& span) {
  if (!result.ok()) {
    span.Set("outcome", std::string(ReasonName(DetailOf(result.status()).reason)));
    span.Set("error", std::string(result.status().message().substr(0, kMaxErrorBytes)));
    return;
  }
  span.Set("outcome", "ok");
  for (const StageInfo& info : kStages)
    if (const double seconds = result->times()[info.stage]; seconds > 0)
      span.Set(absl::StrCat(std::string(info.name), "_s"), absl::StrCat(seconds));
}

}  // namespace

/// Task runner that records which tasks run on it at the moment.
class Fleet::Watched : public TaskRunner {
 public:
  Watched(Runner runner, int64_t member) : runner_(std::move(runner)), member_(member) {}

  ProcessSet processes() const override { return runner_.tasks->processes(); }

  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override {
    const std::string& name = task.label().text;
    const int64_t turn = Begin(call, task);
    StageCall traced = call;
    traced.trace = ChildSpan(call.trace, absl::StrCat(name, " ", member_, "/", turn));
    ScopedSpan span(call.spans, name, runner_.name);
    span.Set("span_id", traced.trace.span_id);
    auto result = runner_.tasks->RunTask(traced, task);
    NoteOutcome(result, span);
    End(turn);
    return result;
  }

  RunnerAtWork Now() const {
    RunnerAtWork now = {runner_.name, runner_.slots, {}};
    const std::lock_guard lock(mutex_);
    for (const auto& [turn, at_work] : at_work_) {
      now.tasks.push_back({at_work.job_id, at_work.task, at_work.clock.Seconds()});
    }
    return now;
  }

 private:
  struct AtWork {
    std::string job_id;
    std::string task;
    Stopwatch clock = {};
  };

  int64_t Begin(const StageCall& call, const Task& task) const {
    const std::lock_guard lock(mutex_);
    at_work_.emplace(++turns_, AtWork{call.job_id, task.label().text});
    return turns_;
  }

  void End(int64_t turn) const {
    const std::lock_guard lock(mutex_);
    at_work_.erase(turn);
  }

  const Runner runner_;
  const int64_t member_;
  mutable std::mutex mutex_;
  mutable int64_t turns_ = 0;
  mutable std::map<int64_t, AtWork> at_work_;
};

RunnerId Fleet::Join(Runner runner) {
  const std::lock_guard lock(mutex_);
  const auto watched = std::make_shared<const Watched>(runner, next_member_++);
  runner.tasks = watched;
  const RunnerId id = runners_.Join(std::move(runner));
  members_[id] = watched;
  return id;
}

void Fleet::Leave(RunnerId id) {
  const std::lock_guard lock(mutex_);
  runners_.Leave(id);
  members_.erase(id);
}

std::vector<RunnerAtWork> Fleet::Runners() const {
  const std::lock_guard lock(mutex_);
  std::vector<RunnerAtWork> runners;
  for (const auto& [id, member] : members_) runners.push_back(member->Now());
  return runners;
}

}  // namespace slicefarm::coordinator
