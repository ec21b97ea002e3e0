#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/model/sha256.h"
#include "common/model/temp_directory_test.h"
#include "common/rpc/server.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/algo/dispatcher.h"
#include "services/coordinator/algo/fleet.h"
#include "services/coordinator/server/coordinator.h"
#include "services/coordinator/server/coordinator_client_test.h"
#include "services/coordinator/server/fake_stages_test.h"

namespace slicefarm::coordinator {

/// For tests: the coordinator over a real server and real stores, with fake stages.
class CoordinatorTest : public testing::Test, protected CoordinatorClient {
 protected:
  CoordinatorTest() {
    fleet_.Join({.name = "fake", .ranges = ranges_, .slots = 2});
    Open();
  }

  ~CoordinatorTest() override {
    ranges_->LetGo();
    Close();
  }

  void Open() {
    CoordinatorOptions options;
    options.stores.state_dir = directory_.path();
    options.build_id = "test-build";
    options.runner.owner = "coordinator";
    options.runner.jobs = jobs_at_once_;
    options.runner.poll = std::chrono::milliseconds(20);
    options.transfers = transfers_;
    options.rates = rates_;
    options.webhooks = webhooks_;
    options.webhook_sender.poll = std::chrono::milliseconds(20);
    options.webhook_sender.first_retry = std::chrono::milliseconds(50);
    options.webhook_sender.max_attempts = 3;
    options.min_free_bytes = min_free_bytes_;
    options.metrics = &registry_;
    auto coordinator =
        Coordinator::Open(options, slicing_, motion_, dispatcher_, rpc::JsonLog("test"));
    ASSERT_TRUE(coordinator.ok()) << coordinator.status();
    coordinator_ = *std::move(coordinator);
    auto server =
        rpc::Server::Start({}, coordinator_->services(), metrics_, &coordinator_->queued_methods());
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
    Connect(absl::StrCat("127.0.0.1:", server_->port()));
    ASSERT_TRUE(coordinator_->Start().ok());
  }

  /// As SIGTERM does it.
  void Close() {
    if (!coordinator_) return;
    coordinator_->Stop();
    server_->Drain(std::chrono::seconds(10));
    server_.reset();
    coordinator_.reset();
  }

  /// Uploads the mesh and makes a job of it.
  std::string Submit(const std::string& mesh) {
    EXPECT_TRUE(Upload(mesh).ok());
    const auto job = Create(RequestFor(mesh));
    EXPECT_TRUE(job.ok()) << job.status();
    return job.ok() ? job->id() : "";
  }

  v1::Job Get(const std::string& id) {
    grpc::ClientContext context;
    v1::GetJobRequest request;
    request.set_id(id);
    v1::Job job;
    EXPECT_TRUE(jobs_->GetJob(&context, request, &job).ok());
    return job;
  }

  /// The events after `after`, to the end of the stream.
  std::vector<v1::JobEvent> Watch(const std::string& id, int64_t after = 0,
                                  absl::Status* end = nullptr) {
    grpc::ClientContext context;
    v1::WatchJobRequest request;
    request.set_id(id);
    request.set_after_sequence(after);
    const auto stream = jobs_->WatchJob(&context, request);
    std::vector<v1::JobEvent> events;
    v1::JobEvent event;
    while (stream->Read(&event)) events.push_back(event);
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    if (end != nullptr) *end = status;
    return events;
  }

  v1::Job AwaitEnd(const std::string& id) {
    Watch(id);
    return Get(id);
  }

  absl::StatusOr<std::string> Download(const std::string& id, v1::Artifact artifact,
                                       int64_t offset = 0) {
    grpc::ClientContext context;
    v1::DownloadRequest request;
    request.set_id(id);
    request.set_artifact(artifact);
    request.set_offset(offset);
    const auto stream = jobs_->Download(&context, request);
    std::string bytes;
    v1::DownloadResponse response;
    while (stream->Read(&response)) {
      EXPECT_LE(response.data().size(), 65'536u);
      bytes += response.data();
    }
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    if (!status.ok()) return status;
    return bytes;
  }

  absl::Status Cancel(const std::string& id) {
    grpc::ClientContext context;
    v1::CancelJobRequest request;
    request.set_id(id);
    v1::Job job;
    return rpc::FromGrpc(jobs_->CancelJob(&context, request, &job));
  }

  absl::Status Delete(const std::string& id) {
    grpc::ClientContext context;
    v1::DeleteJobRequest request;
    request.set_id(id);
    google::protobuf::Empty empty;
    return rpc::FromGrpc(jobs_->DeleteJob(&context, request, &empty));
  }

  /// A call that hangs is to fail the test, not to hang it.
  static void Bound(grpc::ClientContext& context) {
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::minutes(2));
  }

  /// Opens an upload, and waits until its first bytes have arrived.
  struct OpenUpload {
    grpc::ClientContext context;
    v1::Upload upload;
    std::unique_ptr<grpc::ClientWriter<v1::UploadMeshRequest>> stream;
  };
  std::unique_ptr<OpenUpload> BeginUpload(const std::string& mesh) {
    auto open = std::make_unique<OpenUpload>();
    Bound(open->context);
    open->stream = meshes_->UploadMesh(&open->context, &open->upload);
    v1::UploadMeshRequest request;
    request.set_sha256(Sha256Hex(mesh));
    request.set_size(std::ssize(mesh));
    request.set_data(mesh.substr(0, 1));
    EXPECT_TRUE(open->stream->Write(request));
    while (GetUpload(Sha256Hex(mesh)).committed_size() == 0) std::this_thread::yield();
    return open;
  }

  /// Calls of a method that have ended on the server, whatever they came to.
  double Handled(const std::string& method) {
    double count = 0;
    for (const auto& family : registry_.Collect()) {
      if (family.name != "grpc_server_handled_total") continue;
      for (const auto& metric : family.metric) {
        for (const auto& label : metric.label) {
          if (label.value == method) count += metric.counter.value;
        }
      }
    }
    return count;
  }

  TransferOptions transfers_;
  Rates rates_;
  WebhookPolicy webhooks_;
  int64_t min_free_bytes_ = 0;
  int jobs_at_once_ = 2;
  TempDirectory directory_;
  FakeSlicing slicing_;
  FakeMotion motion_;
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  Dispatcher dispatcher_;
  Fleet fleet_{dispatcher_};
  prometheus::Registry registry_;
  rpc::CallMetrics metrics_{registry_};
  std::unique_ptr<Coordinator> coordinator_;
  std::unique_ptr<rpc::Server> server_;
};

}  // namespace slicefarm::coordinator
