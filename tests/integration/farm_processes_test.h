#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/base/temp_directory_test.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "tests/corpus_file.h"
#include "tests/integration/child_process.h"

namespace slicefarm {

/// Client for tests, which can watch jobs.
class FarmClient : public coordinator::CoordinatorClient {
 public:
  explicit FarmClient(const std::string& address) { Connect(address); }

  /// Watches until `enough` returns true, or the stream ends. Returns the last event.
  v1::JobEvent Watch(const std::string& id, int64_t after,
                     const std::function<bool(const v1::Job&)>& enough = {}) {
    grpc::ClientContext context;
    v1::WatchJobRequest request;
    request.set_id(id);
    request.set_after_sequence(after);
    const auto stream = jobs_->WatchJob(&context, request);
    v1::JobEvent event;
    while (stream->Read(&event)) {
      EXPECT_GE(event.sequence(), after) << "progress has the number of the last event";
      after = event.sequence();
      if (enough && enough(event.job())) break;
    }
    context.TryCancel();
    (void)stream->Finish();
    return event;
  }
};

/// Test fixture with stages and workers as processes, and a coordinator that the test starts, kills
/// and starts again.
class FarmProcessesTest : public testing::Test {
 protected:
  /// Returns the arguments of a coordinator with the fused workers, plus further arguments.
  std::vector<std::string> Arguments(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {
        "--slicing", slicing_.address, "--planning", planning_.address,
        "--motion",  motion_.address,  "--workers",  first_.address + "," + second_.address};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  void StartCoordinator(const TempDirectory& state, const std::vector<std::string>& more = {}) {
    std::vector<std::string> own = {"--state-dir", state.path(), "--metrics-port", "0"};
    own.insert(own.end(), more.begin(), more.end());
    server_.emplace("slicefarm-coordinator", Arguments(std::move(own)));
    client_.emplace(server_->address);
  }

  void AwaitWorkers(int count) const {
    server_->AwaitMetric("slicefarm_workers " + std::to_string(count));
  }
  /// Waits for this number of ranges in the workers.
  void AwaitBusySlots(int count) const {
    server_->AwaitMetric("slicefarm_worker_slots{state=\"busy\"} " + std::to_string(count));
  }

  /// Checks that a range without an answer was computed by another worker, long before its
  /// connection was given up.
  void ExpectDoubled() const {
    EXPECT_NE(server_->Metric("slicefarm_ranges_total{outcome=\"hedged\"}"), "0");
  }

  /// Runs a job before the tested one, so that all services have been connected.
  void WarmUp() {
    EXPECT_TRUE(client_->Upload(mesh_).ok());
    v1::CreateJobRequest request = FarmClient::RequestFor(mesh_);
    request.mutable_spec()->mutable_objects(0)->set_name("another name, another job");
    const auto job = client_->Create(request);
    ASSERT_TRUE(job.ok()) << job.status();
    EXPECT_EQ(client_->Watch(job->id(), 0).job().state(), v1::JOB_STATE_SUCCEEDED);
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

  /// Submits a job and stops both workers while each of them has a range of it.
  std::string SubmitToStoppedWorkers() {
    AwaitWorkers(2);
    StopWorkers();
    std::string id = Submit();
    AwaitBusySlots(2);
    return id;
  }

  v1::Job Create(const std::string& request_id = "") {
    v1::CreateJobRequest request = FarmClient::RequestFor(mesh_);
    request.set_request_id(request_id);
    const auto job = client_->Create(request);
    EXPECT_TRUE(job.ok()) << job.status();
    return job.value_or(v1::Job());
  }

  static bool IsSliced(const v1::Job& job) { return job.progress().layers_total() > 0; }

  /// Returns the digest of the G-code without any failure.
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
  ServerProcess planning_{"slicefarm-planning"};
  ServerProcess motion_{"slicefarm-motion"};
  ServerProcess first_{"slicefarm-worker", {"--slots", "1"}};
  ServerProcess second_{"slicefarm-worker", {"--slots", "1"}};
  std::optional<ServerProcess> server_;
  std::optional<FarmClient> client_;
  const std::string quiet_ = QuietDigest();
  TempDirectory state_;
};

}  // namespace slicefarm
