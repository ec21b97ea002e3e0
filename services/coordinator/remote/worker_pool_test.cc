#include "services/coordinator/remote/worker_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <thread>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "services/coordinator/remote/fake_replica_test.h"

namespace slicefarm::coordinator::worker_pool_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;
using testing::UnorderedElementsAre;

rpc::JsonLog NoLog() {
  return rpc::JsonLog("test", std::make_shared<spdlog::logger>(
                                  "test", std::make_shared<spdlog::sinks::null_sink_mt>()));
}

/// Runner set that records its current members.
class FakeRunnerSet : public RunnerSet {
 public:
  RunnerId Join(Runner runner) override {
    const std::lock_guard lock(mutex_);
    runners_[next_] = std::move(runner);
    return next_++;
  }
  void Leave(RunnerId id) override {
    const std::lock_guard lock(mutex_);
    EXPECT_EQ(runners_.erase(id), 1);
  }
  void Refuse(const std::string& name, const std::string& why) override {
    const std::lock_guard lock(mutex_);
    refused_[name] = why;
  }
  std::string Refused(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    const auto found = refused_.find(name);
    return found == refused_.end() ? "" : found->second;
  }
  std::vector<Runner> Current() const {
    const std::lock_guard lock(mutex_);
    std::vector<Runner> current;
    for (const auto& [id, runner] : runners_) current.push_back(runner);
    return current;
  }
  std::vector<Runner> Await(size_t count) const {
    std::vector<Runner> current = Current();
    for (; current.size() != count; current = Current()) std::this_thread::yield();
    return current;
  }

 private:
  mutable std::mutex mutex_;
  std::map<RunnerId, Runner> runners_;
  std::map<std::string, std::string> refused_;
  RunnerId next_ = 1;
};

class WorkerPoolTest : public testing::Test {
 protected:
  void Start(std::vector<std::string> addresses) {
    name_.Set(std::move(addresses));
    pool_ = std::make_unique<WorkerPool>(
        runners_, std::vector<std::string>{"name:1"}, NoLog(),
        WorkerPoolOptions{
            .watch = name_.Options(), .greet_every = greet_every_, .greeting_patience = patience_});
  }

  milliseconds greet_every_{20};
  milliseconds patience_ = seconds(600);
  FakeName name_;
  FakeRunnerSet runners_;
  std::unique_ptr<WorkerPool> pool_;
};

TEST_F(WorkerPoolTest, WorkersJoinWithTheirSlots) {
  FakeReplica a, b;
  a.SetInfo(std::string(BuildId()), 3);
  b.SetInfo(std::string(BuildId()), 5);
  Start({a.address(), b.address()});
  std::map<std::string, int> slots;
  for (const Runner& runner : runners_.Await(2)) slots[runner.name] = runner.slots;
  EXPECT_EQ(slots, (std::map<std::string, int>{{a.address(), 3}, {b.address(), 5}}));
}

TEST_F(WorkerPoolTest, WorkersComeAndGoWithTheirAddresses) {
  FakeReplica a, b;
  Start({a.address()});
  runners_.Await(1);
  name_.Set({a.address(), b.address()});
  runners_.Await(2);
  name_.Set({b.address()});
  EXPECT_EQ(runners_.Await(1)[0].name, b.address());
  name_.Set({});
  runners_.Await(0);
}

TEST_F(WorkerPoolTest, AllLeaveWhenThePoolGoes) {
  FakeReplica a;
  Start({a.address()});
  runners_.Await(1);
  pool_.reset();
  EXPECT_THAT(runners_.Current(), IsEmpty());
}

TEST_F(WorkerPoolTest, AWorkerThatIsNotThereYetJoinsWhenItIs) {
  FakeReplica a;
  a.Kill();
  Start({a.address()});
  EXPECT_THAT(runners_.Current(), IsEmpty());
  a.Restart();
  EXPECT_THAT(runners_.Await(1), SizeIs(1));
}

TEST_F(WorkerPoolTest, AWorkerThatIsDownForAWhileCanBeAwaited) {
  FakeReplica a;
  Start({a.address()});
  const Runner runner = runners_.Await(1)[0];
  EXPECT_TRUE(runner.await_ready(seconds(60)));
  a.Kill();
  while (runner.await_ready(milliseconds(1))) std::this_thread::yield();
  a.Restart();
  EXPECT_TRUE(runner.await_ready(seconds(60)));
  EXPECT_THAT(pool_->Joined(), UnorderedElementsAre(a.address()));
}

TEST_F(WorkerPoolTest, AWorkerOfAnotherBuildDoesNotJoin) {
  FakeReplica old, fit;
  old.SetInfo("0123456789abcdef", 2);
  Start({old.address(), fit.address()});
  runners_.Await(1);
  while (old.calls() == 0) std::this_thread::yield();
  pool_.reset();  // the pool has processed all answers
  EXPECT_THAT(runners_.Current(), IsEmpty());
}

TEST_F(WorkerPoolTest, AWorkerStartedAnewHasTheSlotsItTellsThen) {
  FakeReplica a;
  a.SetInfo(std::string(BuildId()), 3);
  Start({a.address()});
  EXPECT_EQ(runners_.Await(1)[0].slots, 3);
  a.Kill();
  EXPECT_EQ(runners_.Current().size(), 1) << "it is only down";
  a.SetInfo(std::string(BuildId()), 5);
  a.Restart();
  while (runners_.Await(1)[0].slots != 5) std::this_thread::yield();
  a.Kill();
  a.SetInfo("0123456789abcdef", 5);
  a.Restart();
  runners_.Await(0);
}

// Otherwise the loss of all workers would stay unnoticed.
TEST_F(WorkerPoolTest, AWorkerThatDoesNotAnswerLeavesUntilItDoes) {
  patience_ = milliseconds(50);
  FakeReplica a;
  Start({a.address()});
  runners_.Await(1);
  a.Kill();
  runners_.Await(0);
  a.Restart();
  runners_.Await(1);
}

TEST_F(WorkerPoolTest, AWorkerThatIsGreetedAgainStaysTheSameRunner) {
  FakeReplica a;
  Start({a.address()});
  const auto tasks = runners_.Await(1)[0].tasks;
  while (a.calls() < 5) std::this_thread::yield();
  EXPECT_EQ(runners_.Await(1)[0].tasks, tasks);
}

TEST_F(WorkerPoolTest, AWorkerThatBecameOneOfAnotherBuildLeavesWhenItRefusesARange) {
  FakeReplica a;
  greet_every_ = seconds(600);
  Start({a.address()});
  const Runner runner = runners_.Await(1)[0];
  a.Kill();
  a.SetInfo("0123456789abcdef", 2);
  a.OnWork([] {
    return rpc::ToGrpc(
        MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch, "new"));
  });
  a.Restart();
  ASSERT_TRUE(runner.await_ready(seconds(60)));
  FdmTask task;
  task.range = {0, 1};
  for (int i = 0; i < 2; ++i) {
    absl::Status refused;
    do {
      refused = runner.tasks->RunTask({}, task).status();
    } while (absl::IsUnavailable(refused));  // the channel may not have noticed the kill yet
    EXPECT_EQ(DetailOf(refused).reason, Reason::kBuildMismatch);
    EXPECT_THAT(runners_.Current(), IsEmpty());
  }
}

TEST_F(WorkerPoolTest, AWorkerThatFitsAgainJoinsAgain) {
  FakeReplica a;
  a.SetInfo("0123456789abcdef", 2);
  Start({a.address()});
  while (runners_.Refused(a.address()).empty()) std::this_thread::yield();
  EXPECT_THAT(runners_.Refused(a.address()), StartsWith("the worker is of build 0123456789abcdef"));
  a.Kill();
  EXPECT_THAT(runners_.Current(), IsEmpty());
  a.SetInfo(std::string(BuildId()), 4);
  a.Restart();
  EXPECT_EQ(runners_.Await(1)[0].slots, 4);
  EXPECT_EQ(runners_.Refused(a.address()), "");
}

TEST_F(WorkerPoolTest, AWorkerIsARunnerOfTheProcessesThatItTells) {
  FakeReplica a;
  Start({a.address()});
  EXPECT_EQ(runners_.Await(1)[0].tasks->processes(), ProcessSet{Process::kFdm});
  a.Kill();
  a.SetProcesses({v1::PROCESS_LASER});
  a.Restart();
  while (runners_.Await(1)[0].tasks->processes() != ProcessSet{Process::kLaser})
    std::this_thread::yield();
  a.Kill();
  a.SetProcesses({});  // a worker without processes is of no use
  a.Restart();
  runners_.Await(0);
}

TEST_F(WorkerPoolTest, EndsWhileAWorkerIsBeingGreeted) {
  FakeReplica a;
  a.Kill();
  for (int round = 0; round < 20; ++round) {
    Start({a.address()});
    pool_.reset();
  }
  EXPECT_THAT(runners_.Current(), IsEmpty());
}

TEST_F(WorkerPoolTest, RunnersOutliveTheirMembership) {
  FakeReplica a;
  Start({a.address()});
  const Runner runner = runners_.Await(1)[0];
  pool_.reset();
  FdmTask task;
  task.range = {0, 1};
  EXPECT_FALSE(runner.tasks->RunTask({}, task).ok());  // the fake implements no WorkRange
}

}  // namespace
}  // namespace slicefarm::coordinator::worker_pool_test
