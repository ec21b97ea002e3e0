// Tests the coordinator as a process among processes, under real signals. Workers are stopped
// (SIGSTOP) where a job must not end before an event, so that nothing depends on timing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "tests/integration/child_process.h"
#include "tests/integration/farm_processes_test.h"
#include "tests/integration/http_get.h"

namespace slicefarm::coordinator_processes_test {
namespace {

class CoordinatorProcessesTest : public FarmProcessesTest {};

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
  // Each run of the coordinator may write one more event than the run before.
  for (int life = 1;; ++life) {
    int events = 0;
    const v1::JobEvent last =
        client_->Watch(id, seen, [&](const v1::Job&) { return ++events >= life; });
    seen = std::max(seen, last.sequence());
    // A job that has repeatedly crashed coordinators waits between its attempts.
    if (last.job().state() != v1::JOB_STATE_RUNNING && life > 1) break;
    KillCoordinator();
    StartCoordinator(state_);
  }
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(CoordinatorProcessesTest, SigtermLetsARunningJobEnd) {
  StartCoordinator(state_, {"--drain", "600"});
  const std::string id = SubmitToStoppedWorkers();
  client_.reset();  // an idle channel reads GOAWAY only every 5 s; the server would wait
  server_->process.Signal(SIGTERM);
  ContinueWorkers();
  EXPECT_EQ(server_->process.Wait(), 0);
  StopWorkers();
  StartCoordinator(state_);
  EXPECT_EQ(client_->Get(id)->state(), v1::JOB_STATE_SUCCEEDED) << "before any worker was back";
  ContinueWorkers();
}

TEST_F(CoordinatorProcessesTest, SigtermHandsTheJobOverToTheNextLife) {
  StopWorkers();
  StartCoordinator(state_, {"--drain", "6"});
  const std::string id = Submit();
  const v1::JobEvent last = client_->Watch(id, 0, IsSliced);
  client_.reset();  // an idle channel reads GOAWAY only every 5 s; the server would wait
  server_->process.Signal(SIGTERM);
  EXPECT_EQ(server_->process.Wait(), 0);
  ContinueWorkers();
  StartCoordinator(state_);
  ExpectTheSame(client_->Watch(id, last.sequence()));
}

TEST_F(CoordinatorProcessesTest, AWorkerThatDrainsLosesNothing) {
  StartCoordinator(state_);
  const std::string id = SubmitToStoppedWorkers();
  first_.process.Signal(SIGTERM);
  ContinueWorkers();
  ExpectTheSame(client_->Watch(id, 0));
  EXPECT_EQ(first_.process.Wait(), 0);
}

TEST_F(CoordinatorProcessesTest, AKilledWorkerLosesNothing) {
  StartCoordinator(state_);
  const std::string id = SubmitToStoppedWorkers();
  first_.process.Signal(SIGKILL);
  second_.process.Signal(SIGCONT);
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(CoordinatorProcessesTest, AStoppedWorkerHoldsNothingUp) {
  StartCoordinator(state_);
  const std::string id = SubmitToStoppedWorkers();
  second_.process.Signal(SIGCONT);
  ExpectTheSame(client_->Watch(id, 0));
  ExpectDoubled();
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

/// Returns the G-code of `slicefarm slice --plates` with these arguments, by plate.
std::vector<std::string> SlicedPlates(const TempDirectory& folder,
                                      std::vector<std::string> arguments) {
  const std::string output = folder.path() + "/out.gcode";
  arguments.insert(arguments.end(), {"--plates", "-q", "-o", output});
  EXPECT_EQ(ChildProcess("slicefarm", std::move(arguments)).Wait(), 0);
  std::vector<std::string> plates;
  for (int i = 1;; ++i) {
    std::ifstream file(folder.path() + "/out-" + std::to_string(i) + ".gcode");
    if (!file) return plates;
    plates.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
}

TEST_F(CoordinatorProcessesTest, PlatesAreMadeOnceAndTheSameAsHere) {
  const std::string model = state_.path() + "/part.stl";  // same name as FarmClient's object
  std::ofstream(model, std::ios::binary) << mesh_;
  const TempDirectory folder;
  const std::vector<std::string> here = SlicedPlates(
      folder,
      {"slice", model, "--copies", "part.stl=7", "--set", "bed_shape=0x0,250x0,250x210,0x210"});
  ASSERT_GT(here.size(), 1u);
  v1::CreatePlatesRequest request;
  request.set_request_id("plates");
  v1::JobSpec& spec = *request.add_requests()->mutable_spec();
  spec = FarmClient::RequestFor(mesh_).spec();
  spec.mutable_objects(0)->set_copies(7);
  v1::Setting& bed = *spec.add_settings();
  bed.set_key("bed_shape");
  bed.set_value("0x0,250x0,250x210,0x210");
  const auto create = [&] {
    grpc::ClientContext context;
    v1::CreatePlatesResponse response;
    const grpc::Status status = client_->jobs_->CreatePlates(&context, request, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    std::vector<std::string> ids;
    for (const v1::Job& job : response.jobs()) ids.push_back(job.id());
    return ids;
  };
  StartCoordinator(state_);
  ASSERT_TRUE(client_->Upload(mesh_).ok());
  const std::vector<std::string> ids = create();
  KillCoordinator();
  StartCoordinator(state_);
  EXPECT_EQ(create(), ids) << "the call is made again, as its answer may have been lost";
  ASSERT_EQ(ids.size(), here.size());
  for (size_t i = 0; i < ids.size(); ++i) {
    const v1::JobEvent end = client_->Watch(ids[i], 0);
    EXPECT_EQ(end.job().state(), v1::JOB_STATE_SUCCEEDED) << end.job().error().message();
    EXPECT_EQ(end.job().result().gcode_sha256(), Sha256Hex(here[i])) << i;
  }
}

TEST_F(CoordinatorProcessesTest, SplitStagesGiveTheSameBytes) {
  const ServerProcess beading("slicefarm-beading"), infill("slicefarm-infill");
  const ServerProcess ordering("slicefarm-ordering");
  server_.emplace("slicefarm-coordinator",
                  std::vector<std::string>{
                      "--state-dir", state_.path(), "--slicing", slicing_.address, "--planning",
                      planning_.address, "--motion", motion_.address, "--beading", beading.address,
                      "--infill", infill.address, "--ordering", ordering.address});
  client_.emplace(server_->address);
  ExpectTheSame(client_->Watch(Submit(), 0));
}

/// Returns arguments of a coordinator without available services. It must serve nevertheless.
std::vector<std::string> Alone(const TempDirectory& state) {
  return {"--state-dir", state.path(), "--slicing",   "127.0.0.1:1", "--planning",
          "127.0.0.1:1", "--motion",   "127.0.0.1:1", "--workers",   "127.0.0.1:1"};
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
  const std::vector<std::string> some = {"--state-dir", state.path(), "--slicing", "a:1",
                                         "--planning",  "a:1",        "--motion",  "a:1"};
  auto half = some;
  half.insert(half.end(), {"--beading", "a:1"});
  const auto with = [](std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  struct Case {
    std::vector<std::string> arguments;
    std::string error;  ///< beginning of the error text
  };
  for (const Case& c :
       {Case{some, "either --workers or "}, Case{half, "--beading, --infill and --ordering go "},
        Case{{}, "--slicing is "},
        Case{{"--slicing", "a:1", "--motion", "a:1", "--workers", "a:1"}, "--planning is "},
        Case{with(some, {"--workers", "a:1", "--split-slots", "4"}), "--split-slots requires "},
        Case{with(some, {"--workers", "a:1", "--max-concurrent", "4"}), "The following argument"},
        Case{with({"--postgres", "x", "--min-free", "1"}, {some.begin() + 2, some.end()}),
             "--postgres excludes "},
        Case{with({some.begin() + 2, some.end()}, {"--workers", "a:1"}), "one of --state-dir "}}) {
    ChildProcess process("slicefarm-coordinator", c.arguments, ChildProcess::Stderr::kWithStdout);
    EXPECT_NE(process.AwaitLine(c.error), "") << c.error;
    EXPECT_NE(process.Wait(), 0);
  }
}

}  // namespace
}  // namespace slicefarm::coordinator_processes_test
