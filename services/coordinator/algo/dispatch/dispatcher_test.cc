#include "services/coordinator/algo/dispatch/dispatcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <random>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "processes/laser/task/laser_task.h"

namespace slicefarm::coordinator::dispatcher_test {
namespace {

using testing::HasSubstr;

/// Makes a runner that calls `run` for each task.
class FakeRunner : public FdmRunner {
 public:
  using Body = std::function<absl::Status(const StageCall&, const FdmTask&)>;
  FakeRunner(Body body, std::string gcode) : body_(std::move(body)), gcode_(std::move(gcode)) {}

  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const override {
    if (absl::Status status = body_(call, task); !status.ok()) return status;
    FdmResult result;
    for (int i = task.range.first; i < task.range.last; ++i) {
      LayerProgram program;
      program.frame.index = i;
      program.gcode = gcode_;
      result.programs.push_back(program);
    }
    return result;
  }

 private:
  Body body_;
  std::string gcode_;
};

Runner RunnerOf(std::string name, FakeRunner::Body body, int slots = 1, std::string gcode = "") {
  return {.name = std::move(name),
          .tasks = std::make_shared<FakeRunner>(std::move(body), std::move(gcode)),
          .slots = slots,
          .await_ready = {}};
}

absl::Status Good(const StageCall&, const FdmTask&) { return absl::OkStatus(); }
absl::Status Unavailable(const StageCall&, const FdmTask&) {
  return absl::UnavailableError("gone");
}
/// Waits without an answer until the call is cancelled.
absl::Status Stuck(const StageCall& call, const FdmTask&) {
  while (!call.cancel.Cancelled()) std::this_thread::yield();
  return call.cancel.Check();
}

std::vector<Task> Tasks(int count, int layers_each = 10) {
  std::vector<Task> tasks;
  for (int i = 0; i < count; ++i) {
    FdmTask task;
    task.range = {i * layers_each, (i + 1) * layers_each};
    tasks.push_back(task);
  }
  return tasks;
}

DispatcherOptions Quick() {
  DispatcherOptions options;
  options.min_rest = std::chrono::milliseconds(1);
  options.max_rest = std::chrono::milliseconds(4);
  options.scheduler.hedge_after_s = 0;
  return options;
}

/// Runs the tasks and returns all results, in the order of the tasks.
absl::StatusOr<std::vector<TaskResult>> Results(Dispatcher& dispatcher, const StageCall& call,
                                                const std::vector<Task>& tasks,
                                                const std::function<void(int32_t)>& layers_done) {
  std::vector<TaskResult> results(tasks.size());
  std::vector<std::atomic<int>> times(tasks.size());
  const auto take = [&](size_t task, TaskResult result) {
    results[task] = std::move(result);
    EXPECT_EQ(++times[task], 1) << "task " << task << " is taken once";
    return absl::OkStatus();
  };
  if (absl::Status made = dispatcher.Execute(call, tasks, take, layers_done); !made.ok())
    return made;
  return results;
}

testing::AssertionResult IsWhole(const absl::StatusOr<std::vector<TaskResult>>& results,
                                 const std::vector<Task>& tasks) {
  if (!results.ok()) return testing::AssertionFailure() << results.status();
  if (results->size() != tasks.size()) return testing::AssertionFailure() << results->size();
  for (size_t i = 0; i < tasks.size(); ++i) {
    const auto& programs = (*results)[i].As<FdmResult>().programs;
    if (static_cast<int>(programs.size()) != tasks[i].As<FdmTask>().range.size() ||
        programs[0].frame.index != tasks[i].As<FdmTask>().range.first) {
      return testing::AssertionFailure() << "range " << i;
    }
  }
  return testing::AssertionSuccess();
}

TEST(Dispatcher, RunsAllRangesInOrder) {
  Dispatcher dispatcher;
  dispatcher.Join(RunnerOf("a", Good, 3));
  dispatcher.Join(RunnerOf("b", Good, 2));
  EXPECT_EQ(dispatcher.Slots(Process::kFdm), 5);
  const auto tasks = Tasks(50);
  std::vector<int32_t> done;
  EXPECT_TRUE(
      IsWhole(Results(dispatcher, {}, tasks, [&](int32_t n) { done.push_back(n); }), tasks));
  ASSERT_FALSE(done.empty());
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.back(), 500);
  EXPECT_EQ(dispatcher.Counts().done, 50);
}

// A job ends only when its last result is taken.
TEST(Dispatcher, AnErrorOfWhoTakesTheResultsEndsTheJob) {
  Dispatcher dispatcher(Quick());
  dispatcher.Join(RunnerOf("a", Good, 3));
  for (const size_t bad : {size_t{0}, size_t{7}, size_t{19}}) {
    const auto take = [&](size_t task, const TaskResult&) {
      if (task != bad) return absl::OkStatus();
      std::this_thread::yield();
      return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, "full");
    };
    EXPECT_EQ(DetailOf(dispatcher.Execute({}, Tasks(20), take, nullptr)).reason, Reason::kDiskFull)
        << bad;
  }
}

TEST(Dispatcher, NothingToDoIsDone) {
  Dispatcher dispatcher;
  const auto results = Results(dispatcher, {}, {}, nullptr);
  ASSERT_TRUE(results.ok());
  EXPECT_TRUE(results->empty());
}

TEST(Dispatcher, WaitsForARunner) {
  Dispatcher dispatcher;
  const auto tasks = Tasks(4);
  std::thread later([&] { dispatcher.Join(RunnerOf("late", Good)); });
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
  later.join();
}

TEST(Dispatcher, InputErrorsEndTheJobAtOnce) {
  Dispatcher dispatcher(Quick());
  std::atomic<int> calls = 0;
  dispatcher.Join(RunnerOf("a", [&](const StageCall&, const FdmTask&) {
    ++calls;
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange, "too wide");
  }));
  const auto results = Results(dispatcher, {}, Tasks(5), nullptr);
  EXPECT_TRUE(absl::IsInvalidArgument(results.status()));
  EXPECT_EQ(DetailOf(results.status()).reason, Reason::kOutOfRange);
  EXPECT_EQ(calls, 1);
}

// Layer texts a thousand times as long as the request would use up the coordinator's memory.
TEST(Dispatcher, AProgramHasABound) {
  DispatcherOptions options = Quick();
  options.most_program_bytes = 1'000;
  Dispatcher dispatcher(options);
  dispatcher.Join(RunnerOf("a", Good, 2, "ten bytes!"));
  EXPECT_TRUE(Results(dispatcher, {}, Tasks(10), nullptr).ok());
  const absl::Status status = Results(dispatcher, {}, Tasks(11), nullptr).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), "1000");
}

TEST(Dispatcher, PoisonedRangeNamesItsLayers) {
  Dispatcher dispatcher(Quick());
  const auto body = [](const StageCall&, const FdmTask& task) {
    return task.range.first == 20 ? absl::InternalError("crash") : absl::OkStatus();
  };
  dispatcher.Join(RunnerOf("a", body));
  dispatcher.Join(RunnerOf("b", body));
  const auto results = Results(dispatcher, {}, Tasks(5), nullptr);
  const ErrorDetail detail = DetailOf(results.status());
  EXPECT_EQ(detail.reason, Reason::kRangePoisoned);
  EXPECT_EQ(detail.metadata.at("layer_first"), "20");
  EXPECT_EQ(detail.metadata.at("layer_last"), "29");
  EXPECT_THAT(results.status().message(), HasSubstr("crash"));
  EXPECT_EQ(dispatcher.Counts().poisoned, 1);

  const auto tasks = Tasks(2);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks)) << "the next job is well";
}

// Without a limit the range would fail forever. After the limit, the other job has the runner back.
TEST(Dispatcher, WhatOneRunnerCannotMakeIsTriedThreeTimes) {
  Dispatcher dispatcher(Quick());
  std::atomic<int> calls = 0;
  dispatcher.Join(RunnerOf("only", [&](const StageCall&, const FdmTask& task) {
    if (task.range.first != 20) return absl::OkStatus();
    ++calls;
    return absl::InternalError("no such layer");
  }));
  const auto results = Results(dispatcher, {}, Tasks(5), nullptr);
  EXPECT_EQ(DetailOf(results.status()).reason, Reason::kRangePoisoned) << results.status();
  EXPECT_EQ(DetailOf(results.status()).metadata.at("tries"), "3");
  EXPECT_EQ(calls, 3);
  const auto tasks = Tasks(2);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
}

TEST(Dispatcher, ABrokenRunnerCostsOnlyTries) {
  Dispatcher dispatcher(Quick());
  dispatcher.Join(RunnerOf("broken", Unavailable, 1));
  dispatcher.Join(RunnerOf("good", Good, 1));
  const auto tasks = Tasks(30);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
}

TEST(Dispatcher, AnUnreachableRunnerGetsNothing) {
  Dispatcher dispatcher(Quick());
  std::atomic<int> calls = 0;
  Runner dead = RunnerOf(
      "dead",
      [&](const StageCall&, const FdmTask&) {
        ++calls;
        return absl::OkStatus();
      },
      4);
  dead.await_ready = [](std::chrono::milliseconds) { return false; };
  dispatcher.Join(std::move(dead));
  dispatcher.Join(RunnerOf("good", Good));
  const auto tasks = Tasks(30);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
  EXPECT_EQ(calls, 0);
}

TEST(Dispatcher, SecondAnswersThatDifferAreCounted) {
  for (const std::string second : {"same", "other"}) {
    Dispatcher dispatcher(Quick());
    std::atomic<bool> begun = false;
    // This copy is superseded but still returns a result.
    const auto slow = [&](const StageCall& call, const FdmTask&) {
      begun = true;
      while (!call.cancel.Cancelled()) std::this_thread::yield();
      return absl::OkStatus();
    };
    dispatcher.Join(RunnerOf("slow", slow, 1, "same"));
    std::thread later([&] {
      while (!begun) std::this_thread::yield();
      dispatcher.Join(RunnerOf("later", Good, 1, second));
    });
    const auto tasks = Tasks(1);
    EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
    later.join();
    EXPECT_EQ(dispatcher.Counts().differing, second == "same" ? 0 : 1);
  }
}

TEST(Dispatcher, AStuckRunnerIsHedged) {
  Dispatcher dispatcher(Quick());
  dispatcher.Join(RunnerOf("stuck", Stuck, 1));
  dispatcher.Join(RunnerOf("good", Good, 1));
  // Waits until the stuck runner has a range of some job.
  while (dispatcher.Counts().hedged == 0) {
    const auto tasks = Tasks(6);
    ASSERT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
  }
}

TEST(Dispatcher, CancelReachesTheCalls) {
  Dispatcher dispatcher;
  std::atomic<int> started = 0;
  const auto body = [&](const StageCall& call, const FdmTask& task) {
    ++started;
    return Stuck(call, task);
  };
  dispatcher.Join(RunnerOf("a", body, 2));
  StageCall call;
  call.cancel = CancelToken([&] { return started > 1; });
  const absl::Status status = Results(dispatcher, call, Tasks(9), nullptr).status();
  EXPECT_TRUE(absl::IsCancelled(status)) << status;
}

TEST(Dispatcher, LeavingGivesTheRangesToOthers) {
  Dispatcher dispatcher(Quick());
  std::atomic<bool> has_one = false;
  const RunnerId stuck =
      dispatcher.Join(RunnerOf("stuck", [&](const StageCall& call, const FdmTask& task) {
        has_one = true;
        has_one.notify_all();
        return Stuck(call, task);
      }));
  std::thread mover([&] {
    has_one.wait(false);
    dispatcher.Leave(stuck);
    dispatcher.Join(RunnerOf("good", Good));
  });
  const auto tasks = Tasks(5);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
  mover.join();
  EXPECT_EQ(dispatcher.Slots(Process::kFdm), 1);
}

TEST(Dispatcher, ARunnerOfAnotherBuildCostsARangeNoTries) {
  Dispatcher dispatcher(Quick());
  std::atomic<int> refusals = 0;
  const auto misfit = [&](const StageCall&, const FdmTask&) -> absl::Status {
    if (++refusals > 40) return absl::OkStatus();
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch, "old");
  };
  dispatcher.Join(RunnerOf("a", misfit));
  dispatcher.Join(RunnerOf("b", misfit));
  const auto tasks = Tasks(2);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
  EXPECT_EQ(dispatcher.Counts().poisoned, 0);
}

TEST(Dispatcher, JobsShareTheRunners) {
  Dispatcher dispatcher;
  std::atomic<bool> both = false;
  std::string order;
  // The first call waits until both jobs exist. After that, the only slot alternates between the
  // jobs.
  dispatcher.Join(RunnerOf("a", [&](const StageCall& call, const FdmTask&) {
    both.wait(false);
    order += call.job_id;
    return absl::OkStatus();
  }));
  const auto tasks = Tasks(5);
  const auto run = [&](const std::string& id, const std::function<bool()>& poll) {
    StageCall call;
    call.job_id = id;
    call.cancel = CancelToken(poll);
    EXPECT_TRUE(IsWhole(Results(dispatcher, call, tasks, nullptr), tasks));
  };
  std::atomic<int> seen = 0;
  const auto joined = [&](int bit) {
    return [&, bit] {
      if ((seen |= bit) == 3 && !both.exchange(true)) both.notify_all();
      return false;
    };
  };
  std::thread first(run, "1", joined(1));
  std::thread second(run, "2", joined(2));
  first.join();
  second.join();
  EXPECT_THAT(order, testing::AnyOf("1212121212", "2121212121"));
}

/// Runners fail, stall, leave and join at random while several jobs run. Every job must end with
/// all results.
TEST(Dispatcher, EveryJobEndsWholeUnderChurn) {
  DispatcherOptions options = Quick();
  options.scheduler.poison_tries = 1000;
  options.scheduler.max_tries = 1000;
  Dispatcher dispatcher(options);
  std::atomic<uint32_t> salt = 1;
  const auto flaky = [&](const StageCall& call, const FdmTask&) {
    std::mt19937 random(salt++);
    const uint32_t what = random() % 10;
    if (what < 3) return absl::UnavailableError("flaky");
    if (what == 3) {
      for (int i = 0; i < 200 && !call.cancel.Cancelled(); ++i) std::this_thread::yield();
    }
    return absl::OkStatus();
  };
  dispatcher.Join(RunnerOf("constant", flaky, 2));
  std::mutex mutex;
  std::vector<RunnerId> ids;
  // After each progress report, one runner joins and one leaves.
  const auto churn = [&](int32_t) {
    std::lock_guard lock(mutex);
    ids.push_back(dispatcher.Join(RunnerOf("churn", flaky, 1 + static_cast<int>(ids.size()) % 3)));
    if (ids.size() <= 4) return;
    dispatcher.Leave(ids.front());
    ids.erase(ids.begin());
  };
  std::vector<std::thread> jobs;
  for (int j = 0; j < 4; ++j) {
    jobs.emplace_back([&, j] {
      for (int round = 0; round < 10; ++round) {
        const auto tasks = Tasks(10 + j * 7);
        EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, churn), tasks));
      }
    });
  }
  for (std::thread& job : jobs) job.join();
}

/// Returns an empty result for every task.
class FakeLaser : public LaserRunner {
 public:
  absl::StatusOr<LaserResult> Run(const StageCall&, const LaserTask& task) const override {
    LaserResult result;
    result.programs.resize(static_cast<size_t>(task.range.size()));
    return result;
  }
};

// A laser job waits for a runner that supports lasers. Other jobs continue meanwhile.
TEST(Dispatcher, JobsWaitForRunnersOfTheirProcess) {
  Dispatcher dispatcher;
  dispatcher.Join(RunnerOf("fdm", Good, 2));
  EXPECT_EQ(dispatcher.Slots(Process::kFdm), 2);
  EXPECT_EQ(dispatcher.Slots(Process::kLaser), 0);
  std::vector<Task> lasers(3);
  for (int32_t i = 0; i < 3; ++i) {
    LaserTask task;
    task.range = {i, i + 1};
    lasers[static_cast<size_t>(i)] = task;
  }
  absl::StatusOr<std::vector<TaskResult>> scanned;
  std::thread waits([&] { scanned = Results(dispatcher, {}, lasers, nullptr); });
  const auto tasks = Tasks(20);
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, tasks, nullptr), tasks));
  dispatcher.Join({.name = "laser", .tasks = std::make_shared<FakeLaser>(), .await_ready = {}});
  waits.join();
  ASSERT_TRUE(scanned.ok()) << scanned.status();
  for (const TaskResult& result : *scanned) EXPECT_EQ(result.As<LaserResult>().programs.size(), 1u);
}

/// Runner that dies of one task, together with all tasks that run on it at that time. The runner is
/// back at once.
class MortalRunner {
 public:
  static constexpr int kPoison = 7'000;  ///< first layer of the task that kills the runner

  Runner WithSlots(std::string name, int slots) {
    return RunnerOf(
        std::move(name), [this](const StageCall&, const FdmTask& task) { return Run(task); },
        slots);
  }
  int deaths() const { return deaths_; }
  /// Number of tasks that died together with the poison task.
  int bystanders() const { return bystanders_; }

 private:
  absl::Status Run(const FdmTask& task) {
    const int life = deaths_;
    if (task.range.first == kPoison) {
      // The first death waits for another running task, so that at least one bystander dies.
      for (int i = 0; i < 100'000 && life == 0 && others_ == 0; ++i) std::this_thread::yield();
      ++deaths_;
      return absl::UnavailableError("Socket closed");
    }
    ++others_;
    for (int i = 0; i < 2'000 && deaths_ == life; ++i) std::this_thread::yield();
    --others_;
    if (deaths_ == life) return absl::OkStatus();
    ++bystanders_;
    return absl::UnavailableError("Socket closed");
  }

  std::atomic<int> deaths_{0}, others_{0}, bystanders_{0};
};

TEST(Dispatcher, WhatARunnerDiesOfTakesOthersWithItOnce) {
  DispatcherOptions options = Quick();
  options.scheduler.hedge_burst = 0;
  // Otherwise any runner may get the range after 2 s. On a busy machine 2 s can pass, and the range
  // would be tried again on the same runner.
  options.scheduler.elsewhere_after_s = 1e6;
  Dispatcher dispatcher(options);
  MortalRunner one, two;
  dispatcher.Join(one.WithSlots("one", 2));
  dispatcher.Join(two.WithSlots("two", 2));
  FdmTask poison;
  poison.range = {MortalRunner::kPoison, MortalRunner::kPoison + 1};
  const std::vector<Task> killer = {poison}, others = Tasks(300);
  absl::Status outcome;
  std::thread killing([&] { outcome = Results(dispatcher, {}, killer, nullptr).status(); });
  EXPECT_TRUE(IsWhole(Results(dispatcher, {}, others, nullptr), others));
  killing.join();
  EXPECT_EQ(DetailOf(outcome).reason, Reason::kRangePoisoned) << outcome;
  EXPECT_EQ(one.deaths() + two.deaths(), 3);
  EXPECT_LE(one.bystanders() + two.bystanders(), 1) << "what the first death took along";
}

TEST(Dispatcher, ReportsTheFirstRefusedRunner) {
  Dispatcher dispatcher;
  EXPECT_EQ(dispatcher.Refusal(), "");
  dispatcher.Refuse("b:1", "of another build");
  dispatcher.Refuse("a:1", "without slots");
  EXPECT_EQ(dispatcher.Refusal(), "a:1: without slots");
  dispatcher.Refuse("a:1", "");
  EXPECT_EQ(dispatcher.Refusal(), "b:1: of another build");
}

}  // namespace
}  // namespace slicefarm::coordinator::dispatcher_test
