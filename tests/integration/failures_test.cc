// Tests the statements of docs/reliability.md about broken connections, full disks, and
// damaged bytes, with real processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "tests/integration/farm_processes_test.h"
#include "tests/integration/tcp_proxy.h"

namespace slicefarm::failures_test {
namespace {

std::string ReadAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class FailuresTest : public FarmProcessesTest {
 protected:
  /// Starts a coordinator that can reach only these workers.
  void StartWithWorkers(const std::string& workers) {
    server_.emplace(
        "slicefarm-coordinator",
        std::vector<std::string>{"--state-dir", state_.path(), "--slicing", slicing_.address,
                                 "--planning", planning_.address, "--motion", motion_.address,
                                 "--workers", workers, "--metrics-port", "0"});
    client_.emplace(server_->address);
  }
};

TEST_F(FailuresTest, AConnectionToAWorkerThatIsCutLosesNothing) {
  TcpProxy proxy(first_.address);
  StartWithWorkers(proxy.address());
  AwaitWorkers(1);
  first_.process.Signal(SIGSTOP);
  const std::string id = Submit();
  AwaitBusySlots(1);
  proxy.Cut();
  first_.process.Signal(SIGCONT);
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(FailuresTest, AWorkerThatNobodyHearsOfAnyMoreHoldsNothingUp) {
  TcpProxy proxy(first_.address);
  StartWithWorkers(proxy.address() + "," + second_.address);
  const std::string id = SubmitToStoppedWorkers();
  proxy.Hold();
  ContinueWorkers();
  ExpectTheSame(client_->Watch(id, 0));
  ExpectDoubled();
}

TEST_F(FailuresTest, AClientWhoseConnectionIsCutAgainAndAgainGetsItsGcode) {
  StartCoordinator(state_);
  TcpProxy proxy(server_->address);
  const std::string model = SLICEFARM_CORPUS "/models/textbox.stl";
  const std::string output = state_.path() + "/out.gcode";
  ChildProcess submit("slicefarm",
                      {"submit", model, "-o", output, "--generic", "--server", proxy.address()});
  // Each connection may transfer 100,000 bytes more than the one before.
  std::atomic<bool> ended = false;
  std::thread cutter([&] {
    int64_t until = 0;
    for (int64_t allowed = 1; !ended; allowed += 100'000) {
      until = proxy.passed() + allowed;
      while (!ended && proxy.passed() < until) std::this_thread::yield();
      proxy.Cut();
    }
  });
  EXPECT_EQ(submit.Wait(), 0);
  ended = true;
  cutter.join();
  const std::string here = state_.path() + "/here.gcode";
  EXPECT_EQ(ChildProcess("slicefarm", {"slice", model, "-o", here}).Wait(), 0);
  EXPECT_EQ(ReadAll(output), ReadAll(here));
}

TEST_F(FailuresTest, SlicingThatIsKilledAndStartedAgainLosesNothing) {
  StartCoordinator(state_);
  WarmUp();
  slicing_.process.Signal(SIGSTOP);
  const std::string id = Submit();
  client_->Watch(id, 0, [](const v1::Job& job) { return job.state() == v1::JOB_STATE_RUNNING; });
  slicing_.process.Signal(SIGKILL);
  slicing_.process.Wait();
  const ServerProcess again("slicefarm-slicing", {"--listen", slicing_.address});
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(FailuresTest, PlanningThatIsKilledAndStartedAgainLosesNothing) {
  StartCoordinator(state_);
  WarmUp();
  planning_.process.Signal(SIGSTOP);
  const std::string id = Submit();
  client_->Watch(id, 0, [](const v1::Job& job) { return job.state() == v1::JOB_STATE_RUNNING; });
  planning_.process.Signal(SIGKILL);
  planning_.process.Wait();
  const ServerProcess again("slicefarm-planning", {"--listen", planning_.address});
  ExpectTheSame(client_->Watch(id, 0));
}

// A job waits for a missing stage as long as it takes, and other jobs do not begin in vain.
TEST_F(FailuresTest, JobsWaitForAStageThatIsAwayForLong) {
  StartCoordinator(state_);
  WarmUp();
  planning_.process.Signal(SIGKILL);
  planning_.process.Wait();
  const std::string id = Submit();
  client_->Watch(id, 0, [ran = false](const v1::Job& job) mutable {
    ran = ran || job.state() == v1::JOB_STATE_RUNNING;
    return ran && job.state() == v1::JOB_STATE_QUEUED;
  });
  const auto waiting = client_->Get(id);
  ASSERT_TRUE(waiting.ok()) << waiting.status();
  EXPECT_EQ(waiting->state(), v1::JOB_STATE_QUEUED);
  EXPECT_EQ(waiting->waits_for(), "the planning service: none can be reached");
  EXPECT_FALSE(waiting->has_estimated_end_time());
  // A job with the same work would wait for the first one anyway.
  v1::CreateJobRequest request = FarmClient::RequestFor(mesh_);
  request.mutable_spec()->mutable_objects(0)->set_name("a third name, a third job");
  const auto created = client_->Create(request);
  ASSERT_TRUE(created.ok()) << created.status();
  const std::string other = created->id();
  // A job that begins in vain runs for as long as a call waits for its stage.
  for (int look = 0; look < 200; ++look)
    ASSERT_EQ(client_->Get(other)->state(), v1::JOB_STATE_QUEUED) << look;
  const ServerProcess again("slicefarm-planning", {"--listen", planning_.address});
  ExpectTheSame(client_->Watch(id, 0));
  EXPECT_EQ(client_->Watch(other, 0).job().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(client_->Get(other)->waits_for().empty());
}

TEST_F(FailuresTest, MotionThatIsKilledAndStartedAgainLosesNothing) {
  StartCoordinator(state_);
  WarmUp();
  const std::string done = "slicefarm_ranges_total{outcome=\"ok\"}";
  const int ranges = std::stoi(server_->Metric(done));
  motion_.process.Signal(SIGSTOP);
  const std::string id = Submit();
  server_->AwaitMetric(done + " " + std::to_string(2 * ranges));  // motion is called next
  motion_.process.Signal(SIGKILL);
  motion_.process.Wait();
  const ServerProcess again("slicefarm-motion", {"--listen", motion_.address});
  ExpectTheSame(client_->Watch(id, 0));
}

TEST_F(FailuresTest, AMeshThatRotsIsToldAndCanBeSentAgain) {
  StopWorkers();
  StartCoordinator(state_);
  EXPECT_TRUE(client_->Upload(mesh_).ok());
  KillCoordinator();
  const std::string digest = Sha256Hex(mesh_);
  std::string blob;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(state_.path() + "/blobs"))
    if (entry.path().filename().string().ends_with(digest.substr(2))) blob = entry.path();
  ASSERT_NE(blob, "");
  std::filesystem::permissions(blob, std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::add);
  {
    std::fstream file(blob, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(1000);
    file.put('\x7f');
  }
  StartCoordinator(state_);
  ContinueWorkers();
  const v1::JobEvent end = client_->Watch(Create().id(), 0);
  EXPECT_EQ(end.job().state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(end.job().error().reason(), "BLOB_DIGEST_MISMATCH");
  ExpectTheSame(client_->Watch(Submit(), 0));
}

/// Coordinator with its state on a small disk of its own, with `filler` on it.
class FullDiskTest : public FarmProcessesTest {
 protected:
  static constexpr int kDiskKib = 4096;
  /// This leaves room for the database, its log and the mesh, but not for 1.2 MB of G-code.
  static constexpr int kFillerKib = kDiskKib - 900;

  void StartOnSmallDisk(int filler_kib) {
    std::vector<std::string> arguments = {
        "--user",
        "--map-root-user",
        "--mount",
        "sh",
        "-c",
        "mount -t tmpfs -o size=" + std::to_string(kDiskKib) + "k tmpfs " + state_.path() +
            " && head -c " + std::to_string(filler_kib) + "k /dev/zero > " + state_.path() +
            "/filler && exec " SLICEFARM_BIN "/slicefarm-coordinator \"$@\"",
        "sh"};
    for (const std::string& argument : Arguments({"--state-dir", state_.path(), "--min-free", "0"}))
      arguments.push_back(argument);
    server_.emplace("/usr/bin/unshare", arguments);
    client_.emplace(server_->address);
  }

  void RemoveFiller() {
    std::filesystem::remove("/proc/" + std::to_string(server_->process.pid()) + "/root" +
                            state_.path() + "/filler");
  }
};

TEST_F(FullDiskTest, AnUploadThatDoesNotFitIsToldAndGoesOnLater) {
  StartOnSmallDisk(kFillerKib);
  const std::string big = mesh_ + std::string(2'000'000, '\0');
  const absl::Status full = client_->Upload(big).status();
  EXPECT_TRUE(absl::IsResourceExhausted(full)) << full;
  EXPECT_EQ(DetailOf(full).reason, Reason::kDiskFull);
  RemoveFiller();
  const int64_t there = client_->GetUpload(Sha256Hex(big)).committed_size();
  EXPECT_TRUE(client_->Upload(big, there)->complete());
}

TEST_F(FullDiskTest, AResultThatDoesNotFitWaitsForRoom) {
  StartOnSmallDisk(kFillerKib);
  const std::string id = Submit();
  bool ran = false;
  const v1::JobEvent back = client_->Watch(id, 0, [&](const v1::Job& job) {
    ran = ran || job.state() == v1::JOB_STATE_RUNNING;
    return ran && job.state() != v1::JOB_STATE_RUNNING;
  });
  EXPECT_EQ(back.job().state(), v1::JOB_STATE_QUEUED) << back.job().error().message();
  RemoveFiller();
  ExpectTheSame(client_->Watch(id, 0));
}

}  // namespace
}  // namespace slicefarm::failures_test
