#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "common/base/sha256.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "services/coordinator/server/api/served_coordinator_test.h"

namespace slicefarm::coordinator {

/// Fixture with a coordinator that has options of the test, and with a client of it.
class CoordinatorTest : public ServedCoordinatorTest, protected CoordinatorClient {
 protected:
  CoordinatorTest() { Open(); }

  void Open() {
    CoordinatorOptions options = Options();
    options.runner.jobs = jobs_at_once_;
    options.transfers = transfers_;
    options.calls = calls_;
    options.rates = rates_;
    options.default_profile = default_profile_;
    options.webhooks = [this] { return webhooks_; };
    options.webhook_sender.poll = std::chrono::milliseconds(20);
    options.webhook_sender.first_retry = std::chrono::milliseconds(50);
    options.webhook_sender.max_attempts = 3;
    options.min_free_bytes = min_free_bytes_;
    ASSERT_NO_FATAL_FAILURE(Serve(options));
    Connect(address());
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

  /// Sets a deadline, so that a call without an answer fails the test instead of blocking it.
  static void Bound(grpc::ClientContext& context) {
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::minutes(2));
  }

  /// Upload that is open. Its first bytes have arrived.
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

  /// Returns the number of calls of a method that have ended on the server, with any status.
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
  CallLimits calls_;
  Rates rates_;
  std::string default_profile_;
  std::shared_ptr<const WebhookPolicy> webhooks_ = std::make_shared<const WebhookPolicy>();
  int64_t min_free_bytes_ = 0;
  int jobs_at_once_ = 2;
};

}  // namespace slicefarm::coordinator
