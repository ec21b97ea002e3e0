#include "services/coordinator/remote/stage_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <condition_variable>
#include <future>
#include <map>
#include <thread>

#include "common/base/error.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/remote/fake_replica_test.h"

namespace slicefarm::coordinator::stage_pool_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;

rpc::JsonLog NoLog() {
  return rpc::JsonLog("test", std::make_shared<spdlog::logger>(
                                  "test", std::make_shared<spdlog::sinks::null_sink_mt>()));
}

/// Makes one try: requests a replica's info without the channel's own retries.
absl::Status Ask(const std::shared_ptr<grpc::Channel>& channel) {
  const auto stub = v1::Worker::NewStub(channel);
  v1::WorkerInfo info;
  return rpc::UnaryCall(
      {seconds(60), {}}, v1::GetWorkerInfoRequest(), &info,
      [&](auto&&... arguments) { return stub->AsyncGetWorkerInfo(arguments...); });
}

class StagePoolTest : public testing::Test {
 protected:
  StagePool& Pool(const std::vector<std::string>& addresses, StagePoolOptions options = {}) {
    name_.Set(addresses);
    options.watch = name_.Options();
    pool_ =
        std::make_unique<StagePool>("test", std::vector<std::string>{"name:1"}, NoLog(), options);
    AwaitAddresses(addresses.size());
    return *pool_;
  }
  void AwaitAddresses(size_t count) {
    while (pool_->Addresses().size() != count) std::this_thread::yield();
  }
  absl::Status Call() { return pool_->Call({}, Ask); }

  FakeName name_;
  std::unique_ptr<StagePool> pool_;
};

TEST_F(StagePoolTest, UsesAllReplicasInTurn) {
  FakeReplica a, b, c;
  Pool({a.address(), b.address(), c.address()});
  // The connections become ready at different times. In the end every replica gets a call.
  while (a.calls() == 0 || b.calls() == 0 || c.calls() == 0) ASSERT_TRUE(Call().ok());
  const int before = a.calls();
  for (int i = 0; i < 9; ++i) ASSERT_TRUE(Call().ok());
  EXPECT_EQ(a.calls(), before + 3);
}

TEST_F(StagePoolTest, PrefersTheReplicaWithLeastToDo) {
  FakeReplica a, b;
  StagePool& pool = Pool({a.address(), b.address()});
  while (a.calls() == 0 || b.calls() == 0) ASSERT_TRUE(Call().ok());
  // One call occupies one replica. All further calls go to the other replica meanwhile.
  const int a_before = a.calls();
  const int b_before = b.calls();
  bool a_is_busy = false;
  EXPECT_TRUE(pool.Call({},
                        [&](const auto& channel) {
                          const absl::Status status = Ask(channel);
                          a_is_busy = a.calls() > a_before;
                          for (int i = 0; i < 6; ++i) EXPECT_TRUE(Call().ok());
                          return status;
                        })
                  .ok());
  EXPECT_EQ(a.calls() - a_before, a_is_busy ? 1 : 6);
  EXPECT_EQ(b.calls() - b_before, a_is_busy ? 6 : 1);
}

TEST_F(StagePoolTest, GoesOnWithAnotherReplicaWhenOneFails) {
  FakeReplica a, b;
  StagePool& pool = Pool({a.address(), b.address()});
  while (a.calls() == 0 || b.calls() == 0) ASSERT_TRUE(Call().ok());
  std::vector<grpc::Channel*> tried;
  EXPECT_TRUE(pool.Call({},
                        [&](const auto& channel) {
                          tried.push_back(channel.get());
                          return tried.size() < 2 ? absl::UnavailableError("gone")
                                                  : absl::OkStatus();
                        })
                  .ok());
  ASSERT_EQ(tried.size(), 2);
  EXPECT_NE(tried[0], tried[1]);
  // The replica that failed gets no calls for a while.
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(pool.Call({},
                          [&](const auto& channel) {
                            EXPECT_EQ(channel.get(), tried[1]);
                            return absl::OkStatus();
                          })
                    .ok());
  }
}

TEST_F(StagePoolTest, GivesUpAfterThreeTries) {
  FakeReplica a;
  StagePool& pool = Pool({a.address()});
  int tries = 0;
  const absl::Status status = pool.Call({}, [&](const auto&) {
    ++tries;
    return absl::UnavailableError("gone");
  });
  EXPECT_TRUE(absl::IsUnavailable(status));
  EXPECT_EQ(tries, 3);
}

// The replicas may have died of the call.
TEST_F(StagePoolTest, ACallThatIsLostTwiceIsNotMadeAgain) {
  FakeReplica a, b;
  StagePool& pool = Pool({a.address(), b.address()});
  int tries = 0;
  const absl::Status status = pool.Call({}, [&](const auto&) {
    ++tries;
    return LostCall("test", "connection", "was lost");
  });
  EXPECT_EQ(tries, 2);
  EXPECT_TRUE(WasLost(status)) << status;
  EXPECT_TRUE(absl::IsUnavailable(status));
  EXPECT_FALSE(WasLost(absl::UnavailableError("not there")));
}

TEST_F(StagePoolTest, KnowsReplicasOfItsBuild) {
  FakeReplica a, b;
  StagePool& pool = Pool({a.address(), b.address()});
  EXPECT_TRUE(pool.AwaitReady(seconds(60)));
  EXPECT_TRUE(pool.OfThisBuild());
  a.server().TurnAway();
  b.server().TurnAway();
  EXPECT_FALSE(pool.OfThisBuild()) << "those that stop answer as those of another build";
  Pool({});
  EXPECT_TRUE(pool_->OfThisBuild()) << "nobody says otherwise";
}

TEST_F(StagePoolTest, TriesAnotherBuildElsewhere) {
  FakeReplica a, b;
  StagePool& pool = Pool({a.address(), b.address()});
  while (a.calls() == 0 || b.calls() == 0) ASSERT_TRUE(Call().ok());
  int tries = 0;
  EXPECT_TRUE(pool.Call({},
                        [&](const auto&) {
                          return ++tries > 1 ? absl::OkStatus()
                                             : MakeError(absl::StatusCode::kFailedPrecondition,
                                                         Reason::kBuildMismatch, "old");
                        })
                  .ok());
  EXPECT_EQ(tries, 2);
}

TEST_F(StagePoolTest, ErrorsOfTheCallItselfAreNotTriedAgain) {
  FakeReplica a, b;
  StagePool& pool = Pool({a.address(), b.address()});
  for (const auto code : {absl::StatusCode::kInvalidArgument, absl::StatusCode::kInternal,
                          absl::StatusCode::kCancelled, absl::StatusCode::kDeadlineExceeded}) {
    int tries = 0;
    const absl::Status status = pool.Call({}, [&](const auto&) {
      ++tries;
      return absl::Status(code, "x");
    });
    EXPECT_EQ(status.code(), code);
    EXPECT_EQ(tries, 1);
  }
}

TEST_F(StagePoolTest, AFullReplicaIsAskedAgainWithoutLimit) {
  FakeReplica a;
  StagePool& pool = Pool({a.address()});
  int tries = 0;
  EXPECT_TRUE(pool.Call({},
                        [&](const auto&) {
                          return ++tries > 5 ? absl::OkStatus()
                                             : MakeError(absl::StatusCode::kResourceExhausted,
                                                         Reason::kOverloaded, "full",
                                                         {{rpc::kRetryAfterMs, "1"}});
                        })
                  .ok());
  EXPECT_EQ(tries, 6);
}

TEST_F(StagePoolTest, WaitsForAReplicaToComeBack) {
  FakeReplica a;
  Pool({a.address()});
  ASSERT_TRUE(Call().ok());
  a.Kill();
  auto call = std::async(std::launch::async, [&] { return Call(); });
  a.Restart();
  EXPECT_TRUE(call.get().ok());
}

TEST_F(StagePoolTest, NoReplicaInTimeIsUnavailable) {
  FakeReplica a;
  a.Kill();
  StagePoolOptions options;
  options.connect_patience = milliseconds(50);
  StagePool& pool = Pool({a.address()}, options);
  const absl::Status status = Call();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(DetailOf(status).metadata["stage"], "test");
  EXPECT_FALSE(pool.AwaitReady(milliseconds(1)));
  a.Restart();
  EXPECT_TRUE(pool.AwaitReady(seconds(60)));
}

TEST_F(StagePoolTest, ACancelledCallDoesNotWait) {
  StagePool& pool = Pool({});
  const absl::Status status = pool.Call(CancelToken([] { return true; }), Ask);
  EXPECT_TRUE(absl::IsCancelled(status)) << status;
}

TEST_F(StagePoolTest, ReplicasJoinAndLeave) {
  FakeReplica a, b;
  Pool({a.address()});
  ASSERT_TRUE(Call().ok());
  name_.Set({a.address(), b.address()});
  while (b.calls() == 0) ASSERT_TRUE(Call().ok());
  name_.Set({b.address()});
  AwaitAddresses(1);
  const int before = a.calls();
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(Call().ok());
  EXPECT_EQ(a.calls(), before);
}

// Many threads make calls while replicas die, restart, join and leave. Each call must succeed.
TEST_F(StagePoolTest, CarriesCallsThroughUnrest) {
  FakeReplica a, b, c;
  StagePoolOptions options;
  options.rest = milliseconds(5);
  options.tries = 100;
  Pool({a.address(), b.address()}, options);
  std::atomic<bool> over = false;
  std::atomic<int> done = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      while (!over) {
        const absl::Status status = Call();
        EXPECT_TRUE(status.ok()) << status;
        ++done;
      }
    });
  }
  for (int round = 0; round < 5; ++round) {
    const int before = done;
    a.Kill();
    name_.Set({a.address(), b.address(), c.address()});
    while (done < before + 50) std::this_thread::yield();
    a.Restart();
    b.Kill();
    name_.Set({a.address(), b.address()});
    while (done < before + 100) std::this_thread::yield();
    b.Restart();
  }
  over = true;
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace slicefarm::coordinator::stage_pool_test
