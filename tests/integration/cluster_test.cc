// Tests two coordinators that share a PostgreSQL database, as processes under real signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/base/from_environment_test.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/health.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/store/sql/postgres_connection.h"
#include "tests/integration/farm_processes_test.h"
#include "tests/integration/http_get.h"
#include "tests/integration/postgres_server.h"

namespace slicefarm::cluster_test {
namespace {

using State = v1::JobState;

bool HasEnded(State state) { return state >= v1::JOB_STATE_SUCCEEDED; }

/// Returns true if the process blocks a signal, so that the signal does not end it.
bool Blocks(pid_t pid, int signal) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string word;
  while (status >> word && word != "SigBlk:") {
  }
  uint64_t blocked = 0;
  status >> std::hex >> blocked;
  return (blocked >> (signal - 1) & 1) != 0;
}

class ClusterTest : public FarmProcessesTest {
 protected:
  struct Coordinator {
    Coordinator(std::vector<std::string> arguments)
        : server("slicefarm-coordinator", std::move(arguments)), client(server.address) {}

    ServerProcess server;
    FarmClient client;
  };

  void Start(std::optional<Coordinator>& coordinator, const char* name, const char* jobs = "1") {
    coordinator.emplace(
        Arguments({"--postgres", database_, "--name", name, "--lease", "2", "--jobs", jobs}));
  }

  ClusterTest() {
    Start(a_, "a");
    Start(b_, "b");
  }

  std::string SubmitTo(Coordinator& coordinator) {
    EXPECT_TRUE(coordinator.client.Upload(mesh_).ok());
    const auto job = coordinator.client.Create(FarmClient::RequestFor(mesh_));
    EXPECT_TRUE(job.ok()) << job.status();
    return job.value_or(v1::Job()).id();
  }

  /// Watches again and again, as clients do, until the job ends.
  v1::JobEvent AwaitEnd(Coordinator& coordinator, const std::string& id) {
    v1::JobEvent last;
    while (!HasEnded(last.job().state())) {
      const v1::JobEvent event = coordinator.client.Watch(id, last.sequence());
      if (event.sequence() > 0) last = event;
    }
    return last;
  }

  /// Submits a job that runs on one of the two coordinators. It cannot end while the workers are
  /// stopped.
  std::string Running(Coordinator& watched) {
    StopWorkers();
    std::string id = SubmitTo(*a_);
    watched.client.Watch(id, 0, IsSliced);
    return id;
  }

  PostgresServer postgres_;
  const std::string database_ = postgres_.NewDatabase();
  std::optional<Coordinator> a_;
  std::optional<Coordinator> b_;
};

TEST_F(ClusterTest, WhatOneTakesTheOtherKnows) {
  const std::string id = SubmitTo(*a_);
  ExpectTheSame(AwaitEnd(*b_, id));
  ExpectTheSame(AwaitEnd(*a_, id));
}

// One coordinator is killed while it works, and is started again.
TEST_F(ClusterTest, EqualJobsOfThreeCoordinatorsAreComputedOnce) {
  const int64_t jobs = FromEnvironment("SLICEFARM_EQUAL_JOBS", 200);
  std::optional<Coordinator> c;
  Start(c, "c");
  StopWorkers();
  std::vector<std::string> ids;
  ASSERT_TRUE(a_->client.Upload(mesh_).ok());
  for (int64_t i = 0; i < jobs; ++i) {
    std::optional<Coordinator>& taker = i % 3 == 0 ? a_ : i % 3 == 1 ? b_ : c;
    const auto job = taker->client.Create(FarmClient::RequestFor(mesh_));
    ASSERT_TRUE(job.ok()) << job.status();
    ids.push_back(job->id());
  }
  b_->client.Watch(ids.front(), 0, IsSliced);
  a_->server.process.Signal(SIGKILL);
  Start(a_, "a");
  ContinueWorkers();
  int computed = 0;
  for (const std::string& id : ids) {
    const v1::Job job = AwaitEnd(*b_, id).job();
    EXPECT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error().message();
    EXPECT_EQ(job.result().gcode_sha256(), quiet_);
    computed += job.result().cached() ? 0 : 1;
  }
  EXPECT_EQ(computed, 1);
}

// The cancelled job does not wait for the equal job that runs, because that job may take long.
TEST_F(ClusterTest, ACancelledJobOfADeadOwnerEndsBesideAnEqualOneThatRuns) {
  b_.reset();
  const std::string cancelled = Running(*a_);
  a_->server.process.Signal(SIGSTOP);
  Start(b_, "b", "2");
  grpc::ClientContext context;
  v1::CancelJobRequest request;
  request.set_id(cancelled);
  v1::Job answer;
  ASSERT_TRUE(b_->client.jobs_->CancelJob(&context, request, &answer).ok());
  const std::string equal = SubmitTo(*b_);
  EXPECT_EQ(AwaitEnd(*b_, cancelled).job().state(), v1::JOB_STATE_CANCELLED);
  a_->server.process.Signal(SIGKILL);
  ContinueWorkers();
  ExpectTheSame(AwaitEnd(*b_, equal));
}

TEST_F(ClusterTest, TheOtherTakesOverFromAKilledOne) {
  b_.reset();
  const std::string id = Running(*a_);
  Start(b_, "b");
  a_->server.process.Signal(SIGKILL);
  ContinueWorkers();
  ExpectTheSame(AwaitEnd(*b_, id));
}

TEST_F(ClusterTest, AStoppedOneIsFencedAndGoesOnServing) {
  b_.reset();
  const std::string id = Running(*a_);
  Start(b_, "b");
  a_->server.process.Signal(SIGSTOP);
  ContinueWorkers();
  const v1::JobEvent end = AwaitEnd(*b_, id);
  ExpectTheSame(end);
  a_->server.process.Signal(SIGCONT);
  EXPECT_EQ(AwaitEnd(*a_, id).sequence(), end.sequence()) << "nothing came after the end";
  v1::CreateJobRequest another = FarmClient::RequestFor(mesh_);
  another.mutable_spec()->mutable_objects(0)->set_name("another");
  EXPECT_EQ(AwaitEnd(*a_, a_->client.Create(another)->id()).job().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(AwaitEnd(*a_, id).sequence(), end.sequence()) << "nor when its own run had ended";
}

TEST_F(ClusterTest, ACancelReachesTheOneThatWorks) {
  b_.reset();
  const std::string id = Running(*a_);
  Start(b_, "b");
  grpc::ClientContext context;
  v1::CancelJobRequest request;
  request.set_id(id);
  v1::Job job;
  ASSERT_TRUE(b_->client.jobs_->CancelJob(&context, request, &job).ok());
  EXPECT_EQ(AwaitEnd(*b_, id).job().state(), v1::JOB_STATE_CANCELLED);
  ContinueWorkers();
}

TEST_F(ClusterTest, AJobOutlivesTheDatabase) {
  const std::string id = Running(*b_);
  postgres_.Kill();
  const absl::Status refused = a_->client.Create(FarmClient::RequestFor(mesh_)).status();
  EXPECT_TRUE(absl::IsUnavailable(refused)) << refused;
  EXPECT_EQ(DetailOf(refused).reason, Reason::kStoreFailed);
  EXPECT_TRUE(DetailOf(refused).metadata.contains(rpc::kRetryAfterMs));
  ContinueWorkers();
  postgres_.Start();
  ExpectTheSame(AwaitEnd(*a_, id));
}

TEST_F(ClusterTest, ADatabaseThatIsAwayAtTheStartIsWaitedFor) {
  b_.reset();
  postgres_.Kill();
  // The constructor returns when the server is ready, which needs the database.
  std::thread starting([this] { Start(b_, "b"); });
  ChildProcess ended("slicefarm-coordinator", Arguments({"--postgres", database_, "--name", "c"}));
  while (!Blocks(ended.pid(), SIGTERM)) std::this_thread::yield();
  ended.Signal(SIGTERM);
  EXPECT_EQ(ended.Wait(), 0) << "that it waits keeps it from ending";
  postgres_.Start();
  starting.join();
  ExpectTheSame(AwaitEnd(*b_, SubmitTo(*b_)));
}

TEST_F(ClusterTest, TheSchemaIsMadeBesideWhoWorks) {
  const std::string id = Running(*a_);
  ChildProcess migrate("slicefarm-coordinator", {"migrate", "--postgres", database_});
  EXPECT_EQ(migrate.Wait(), 0);
  ContinueWorkers();
  ExpectTheSame(AwaitEnd(*a_, id));
  ChildProcess away("slicefarm-coordinator",
                    {"migrate", "--wait", "0", "--postgres", "host=/none"});
  EXPECT_EQ(away.Wait(), 1);
}

// Models an upgrade and its reversal. Of the newer build, the test has only the migration of the
// schema.
TEST_F(ClusterTest, ABuildGoesOnAndStartsAgainBesideTheSchemaOfANewerOne) {
  const std::string id = Running(*a_);
  {
    const auto newer = coordinator::PostgresConnection::Open(database_);
    ASSERT_TRUE(newer.ok()) << newer.status();
    const absl::Status taken = (*newer)->Execute(
        "ALTER TABLE jobs ADD COLUMN later BIGINT NOT NULL DEFAULT 0;"
        "INSERT INTO slicefarm_migrations (name) VALUES ('9001_later')");
    ASSERT_TRUE(taken.ok()) << taken;
  }
  a_->server.process.Signal(SIGKILL);
  Start(a_, "a");
  ContinueWorkers();
  ExpectTheSame(AwaitEnd(*a_, id));
  ExpectTheSame(AwaitEnd(*b_, id));
}

TEST_F(ClusterTest, AJobOutlivesADatabaseThatStandsStill) {
  const std::string id = Running(*b_);
  postgres_.Pause();
  ContinueWorkers();
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(3));
  v1::Job unused;
  const grpc::Status waited =
      a_->client.jobs_->CreateJob(&context, FarmClient::RequestFor(mesh_), &unused);
  EXPECT_FALSE(waited.ok()) << "longer than the lease, and nothing is there to keep a job";
  postgres_.Resume();
  // The call without an answer may have created its job after all. One of the two jobs then takes
  // the result of the other.
  const v1::JobEvent end = AwaitEnd(*a_, id);
  EXPECT_EQ(end.job().state(), v1::JOB_STATE_SUCCEEDED) << end.job().error().message();
  EXPECT_EQ(end.job().result().gcode_sha256(), quiet_);
}

// Everything that does not need the database still answers. Calls that need it fail at once.
TEST_F(ClusterTest, ADatabaseThatStandsStillIsTold) {
  std::optional<Coordinator> c;
  c.emplace(
      Arguments({"--postgres", database_, "--name", "c", "--lease", "2", "--metrics-port", "0"}));
  ASSERT_TRUE(c->client.Upload(mesh_).ok());
  const auto channel = rpc::MakeChannel(c->server.address);
  const auto serves = [&](const std::string& service) {
    return rpc::IsServing(channel, service, {std::chrono::seconds(60), {}}).value_or(false);
  };
  c->server.AwaitMetric("slicefarm_store_up 1");
  EXPECT_TRUE(serves(""));
  postgres_.Pause();
  while (serves("")) std::this_thread::yield();
  EXPECT_TRUE(serves(rpc::kLiveService));
  c->server.AwaitMetric("slicefarm_store_up 0");
  EXPECT_THAT(HttpGet(c->server.metrics_port, "/statusz"), testing::HasSubstr("store fails"));
  v1::CreateJobRequest request = FarmClient::RequestFor(mesh_);
  request.set_request_id("once");
  EXPECT_EQ(DetailOf(c->client.Create(request).status()).reason, Reason::kStoreFailed);
  postgres_.Resume();
  while (!serves("")) std::this_thread::yield();
  c->server.AwaitMetric("slicefarm_store_up 1");
  ExpectTheSame(AwaitEnd(*b_, SubmitTo(*c)));
}

// The second one would take the running jobs of the first one, because they have its name.
TEST_F(ClusterTest, TheSecondOfANameDoesNotStart) {
  const std::string id = Running(*a_);
  ChildProcess second(
      "slicefarm-coordinator",
      Arguments({"--listen", "127.0.0.1:0", "--postgres", database_, "--name", "a"}),
      ChildProcess::Stderr::kWithStdout);
  EXPECT_EQ(second.Wait(), 1);
  ContinueWorkers();
  ExpectTheSame(AwaitEnd(*b_, id));
}

TEST_F(ClusterTest, AnUploadMayGoOnAtTheOther) {
  EXPECT_EQ(a_->client.Upload(mesh_, 0, 65'536)->committed_size(), 65'536);
  a_->server.process.Signal(SIGKILL);
  EXPECT_TRUE(b_->client.Upload(mesh_, 65'536)->complete());
  ExpectTheSame(AwaitEnd(*b_, b_->client.Create(FarmClient::RequestFor(mesh_))->id()));
}

}  // namespace
}  // namespace slicefarm::cluster_test
