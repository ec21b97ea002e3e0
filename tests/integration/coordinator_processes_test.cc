// The coordinator as a process among processes, under real signals. Workers are stopped (SIGSTOP)
// where a job must not end before something happens to it, so that nothing depends on timing.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/model/sha256.h"
#include "common/model/temp_directory_test.h"
#include "services/coordinator/server/coordinator_client_test.h"
#include "tests/corpus_file.h"
#include "tests/integration/child_process.h"
#include "tests/integration/http_get.h"

namespace slicefarm {
namespace {

class Client : public coordinator::CoordinatorClient {
 public:
  explicit Client(const std::string& address) { Connect(address); }

  /// Watches until `enough` says so, or the stream ends; the last event.
  v1::JobEvent Watch(const std::string& id, int64_t after,
                     const std::function<bool(const v1::Job&)>& enough = {}) {
    grpc::ClientContext context;
    v1::WatchJobRequest request;
    request.set_id(id);
    request.set_after_sequence(after);
    const auto stream = jobs_->WatchJob(&context, request);
    v1::JobEvent event;
    while (stream->Read(&event)) {
      EXPECT_GT(event.sequence(), after);
      after = event.sequence();
      if (enough && enough(event.job())) break;
    }
    context.TryCancel();
    (void)stream->Finish();
    return event;
  }
};

class CoordinatorProcessesTest : public testing::Test {
 protected:
  void StartCoordinator(const TempDirectory& state) {
    server_.emplace("slicefarm-coordinator",
                    std::vector<std::string>{"--state-dir", state.path(), "--slicing",
                                             slicing_.address, "--motion", motion_.address,
                                             "--workers", first_.address + "," + second_.address});
    client_.emplace(server_->address);
  }

  void KillCoordinator() {
    server_->process.Signal(SIGKILL);
    EXPECT_EQ(server_->process.Wait(), -SIGKILL);
  }

  void StopWorkers() {
    first_.process.Signal(SIGSTOP);
    second_.process.Signal(SIGSTOP);
  }
  void ContinueWorkers() {
    first_.process.Signal(SIGCONT);
    second_.process.Signal(SIGCONT);
  }

  std::string Submit(const std::string& request_id = "") {
    EXPECT_TRUE(client_->Upload(mesh_).ok());
    return Create(request_id).id();
  }

  v1::Job Create(const std::string& request_id = "") {
    v1::CreateJobRequest request = Client::RequestFor(mesh_);
    request.set_request_id(request_id);
    const auto job = client_->Create(request);
    EXPECT_TRUE(job.ok()) << job.status();
    return job.value_or(v1::Job());
  }

  static bool IsSliced(const v1::Job& job) { return job.progress().layers_total() > 0; }

  /// The digest of the G-code that comes out when nothing goes wrong.
  std::string QuietDigest() {
    const TempDirectory state;
    StartCoordinator(state);
    const v1::JobEvent end = client_->Watch(Submit(), 0);
    EXPECT_EQ(end.job().state(), v1::JOB_STATE_SUCCEEDED) << end.job().error().message();
    server_.reset();
    return end.job().result().gcode_sha256();
  }

  void ExpectTheSame(const v1::JobEvent& end) {
    EXPECT_EQ(end.job().state(), v1::JOB_STATE_SUCCEEDED) << end.job().error().message();
    EXPECT_FALSE(end.job().result().cached());
    EXPECT_EQ(end.job().result().gcode_sha256(), quiet_);
  }

  const std::string mesh_ = CorpusFile("models/textbox.stl");
  ServerProcess slicing_{"slicefarm-slicing"};
  ServerProcess motion_{"slicefarm-motion"};
  ServerProcess first_{"slicefarm-worker", {"--slots", "1"}};
  ServerProcess second_{"slicefarm-worker", {"--slots", "1"}};
  std::optional<ServerProcess> server_;
  std::optional<Client> client_;
  const std::string quiet_ = QuietDigest();
  TempDirectory state_;
};

TEST_F(CoordinatorProcessesTest, AnAcknowledgedJobOutlivesTheCoordinator) {
  StopWorkers();
  StartCoordinator(state_);
  const std::string id = Submit();
  KillCoordinator();
  ContinueWorkers();
  StartCoordinator(state_);
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(CoordinatorProcessesTest, AHalfDoneJobOutlivesTheCoordinator) {
  StopWorkers();
  StartCoordinator(state_);
  const std::string id = Submit();
  const v1::JobEvent last = client_->Watch(id, 0, IsSliced);
  ASSERT_EQ(last.job().state(), v1::JOB_STATE_RUNNING);
  KillCoordinator();
  ContinueWorkers();
  StartCoordinator(state_);
  ExpectTheSame(client_->Watch(id, last.sequence()));
}

TEST_F(CoordinatorProcessesTest, ManyKillsLoseNothing) {
  StartCoordinator(state_);
  const std::string id = Submit();
  int64_t seen = 0;
  // Each life is allowed one more event than the one before.
  for (int life = 1;; ++life) {
    int events = 0;
    const v1::JobEvent last =
        client_->Watch(id, seen, [&](const v1::Job&) { return ++events >= life; });
    seen = std::max(seen, last.sequence());
    if (last.job().state() == v1::JOB_STATE_SUCCEEDED) break;
    KillCoordinator();
    StartCoordinator(state_);
  }
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(CoordinatorProcessesTest, SigtermHandsTheJobOverToTheNextLife) {
  StopWorkers();
  StartCoordinator(state_);
  const std::string id = Submit();
  const v1::JobEvent last = client_->Watch(id, 0, IsSliced);
  client_.reset();  // an idle channel looks for GOAWAY only every 5 s, and the server would wait
  server_->process.Signal(SIGTERM);
  EXPECT_EQ(server_->process.Wait(), 0);
  ContinueWorkers();
  StartCoordinator(state_);
  ExpectTheSame(client_->Watch(id, last.sequence()));
}

TEST_F(CoordinatorProcessesTest, AKilledWorkerLosesNothing) {
  first_.process.Signal(SIGSTOP);
  StartCoordinator(state_);
  const std::string id = Submit();
  client_->Watch(id, 0, IsSliced);
  first_.process.Signal(SIGKILL);
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(CoordinatorProcessesTest, AStoppedWorkerHoldsNothingUp) {
  StartCoordinator(state_);
  first_.process.Signal(SIGSTOP);
  ExpectTheSame(client_->Watch(Submit(), 0));
}

TEST_F(CoordinatorProcessesTest, AnUploadGoesOnAfterAKill) {
  StartCoordinator(state_);
  const std::string digest = Sha256Hex(mesh_);
  EXPECT_EQ(client_->Upload(mesh_, 0, 65'536)->committed_size(), 65'536);
  KillCoordinator();
  StartCoordinator(state_);
  EXPECT_EQ(client_->GetUpload(digest).committed_size(), 65'536);
  EXPECT_TRUE(client_->Upload(mesh_, 65'536)->complete());
  ExpectTheSame(client_->Watch(Create().id(), 0));
}

TEST_F(CoordinatorProcessesTest, ARequestIdIsRememberedOverAKill) {
  StartCoordinator(state_);
  const std::string id = Submit("one-and-only");
  KillCoordinator();
  StartCoordinator(state_);
  EXPECT_EQ(Create("one-and-only").id(), id);
}

TEST_F(CoordinatorProcessesTest, SplitStagesGiveTheSameBytes) {
  const ServerProcess beading("slicefarm-beading"), infill("slicefarm-infill");
  const ServerProcess ordering("slicefarm-ordering");
  server_.emplace(
      "slicefarm-coordinator",
      std::vector<std::string>{"--state-dir", state_.path(), "--slicing", slicing_.address,
                               "--motion", motion_.address, "--beading", beading.address,
                               "--infill", infill.address, "--ordering", ordering.address});
  client_.emplace(server_->address);
  ExpectTheSame(client_->Watch(Submit(), 0));
}

/// Arguments of a coordinator whose services are not there, which is no reason not to serve.
std::vector<std::string> Alone(const TempDirectory& state) {
  return {"--state-dir", state.path(),  "--slicing", "127.0.0.1:1",
          "--motion",    "127.0.0.1:1", "--workers", "127.0.0.1:1"};
}

TEST(CoordinatorProgram, EndsWellWhileItIsScraped) {
  for (int round = 0; round < 5; ++round) {
    const TempDirectory state;
    auto arguments = Alone(state);
    arguments.insert(arguments.end(), {"--metrics-port", "0"});
    ChildProcess process("slicefarm-coordinator", arguments);
    const std::string where = process.AwaitLine("metrics on ");
    ASSERT_NE(where, "");
    const int port = std::stoi(where.substr(where.rfind(':') + 1));
    std::atomic<int> scrapes = 0;
    std::atomic<bool> ended = false;
    std::thread scraper([&] {
      while (!ended) {
        HttpGet(port, "/metrics");
        ++scrapes;
      }
    });
    process.AwaitLine("listening on ");
    while (scrapes < 3) std::this_thread::yield();
    process.Signal(SIGTERM);
    EXPECT_EQ(process.Wait(), 0);
    ended = true;
    scraper.join();
  }
}

TEST(CoordinatorProgram, RefusesFlagsThatDoNotFit) {
  const TempDirectory state;
  const std::vector<std::string> some = {"--state-dir", state.path(), "--slicing",
                                         "a:1",         "--motion",   "a:1"};
  auto half = some;
  half.insert(half.end(), {"--beading", "a:1"});
  struct Case {
    std::vector<std::string> arguments;
    std::string error;  ///< begins with this
  };
  for (const Case& c :
       {Case{some, "either --workers or "}, Case{half, "--beading, --infill and --ordering go "},
        Case{{}, "--state-dir is "}}) {
    ChildProcess process("slicefarm-coordinator", c.arguments, ChildProcess::Stderr::kWithStdout);
    EXPECT_NE(process.AwaitLine(c.error), "") << c.error;
    EXPECT_NE(process.Wait(), 0);
  }
}

}  // namespace
}  // namespace slicefarm
