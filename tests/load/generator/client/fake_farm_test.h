#pragma once

#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/rpc/status_mapping.h"
#include "google/protobuf/util/time_util.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::load {

/// Receives a mesh. Deletes itself.
class FakeUpload final : public grpc::ServerReadReactor<v1::UploadMeshRequest> {
 public:
  using Complete = std::function<void(const std::string& bytes)>;

  FakeUpload(v1::Upload* response, Complete complete)
      : response_(response), complete_(std::move(complete)) {
    StartRead(&chunk_);
  }
  void OnReadDone(bool ok) override {
    if (!ok) {
      complete_(bytes_);
      response_->set_complete(true);
      return Finish(grpc::Status::OK);
    }
    bytes_ += chunk_.data();
    StartRead(&chunk_);
  }
  void OnDone() override { delete this; }

 private:
  v1::Upload* const response_;
  const Complete complete_;
  v1::UploadMeshRequest chunk_;
  std::string bytes_;
};

/// Sends messages and ends. Deletes itself.
template <typename Message>
class FakeStream final : public grpc::ServerWriteReactor<Message> {
 public:
  explicit FakeStream(std::vector<Message> messages) : messages_(std::move(messages)) { Advance(); }
  void OnWriteDone(bool ok) override {
    if (!ok) reported_ = messages_.size();
    Advance();
  }
  void OnDone() override { delete this; }

 private:
  void Advance() {
    if (reported_ == messages_.size()) return this->Finish(grpc::Status::OK);
    this->StartWrite(&messages_[reported_++]);
  }

  const std::vector<Message> messages_;
  size_t reported_ = 0;
};

/// Fake coordinator for tests, as clients see it. It can stall and refuse calls.
class FakeFarm : public v1::Meshes::CallbackService {
 public:
  static constexpr int kEvents = 4;

  FakeFarm() : jobs_(*this) {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(this);
    builder.RegisterService(&jobs_);
    server_ = builder.BuildAndStart();
  }
  ~FakeFarm() override {
    GoOn();  // a server cannot end before its calls
    server_->Shutdown(std::chrono::system_clock::now());
  }

  /// Returns the address of the server.
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

  /// Lets GetJob answer `after` calls, then hold the next `hold` calls until all of them have
  /// arrived. After that, GetJob answers all calls.
  void StandStill(int after, int hold) {
    const std::lock_guard lock(mutex_);
    gets_before_ = after;
    gets_to_hold_ = hold;
  }

  // Settings of a test before a run, and results that it checks afterwards:
  std::string gcode = std::string(200'000, 'g');
  std::string gcode_sha256 = Sha256Hex(gcode);
  v1::JobState end_state = v1::JOB_STATE_SUCCEEDED;
  int refusals = 0;              ///< refusals of CreateJob before it accepts a job
  std::string retry_after = "";  ///< milliseconds in a refusal; empty: none
  std::set<std::string> meshes;  ///< digests of the meshes
  std::vector<v1::CreateJobRequest> created;

  grpc::ServerUnaryReactor* GetUpload(grpc::CallbackServerContext* context,
                                      const v1::GetUploadRequest* request,
                                      v1::Upload* response) override {
    const std::lock_guard lock(mutex_);
    response->set_complete(meshes.contains(request->sha256()));
    return Ended(context, grpc::Status::OK);
  }

  grpc::ServerReadReactor<v1::UploadMeshRequest>* UploadMesh(grpc::CallbackServerContext*,
                                                             v1::Upload* response) override {
    return new FakeUpload(response, [this](const std::string& bytes) {
      const std::lock_guard lock(mutex_);
      meshes.insert(Sha256Hex(bytes));
    });
  }

 private:
  class Jobs final : public v1::Jobs::CallbackService {
   public:
    explicit Jobs(FakeFarm& farm) : farm_(farm) {}

    grpc::ServerUnaryReactor* CreateJob(grpc::CallbackServerContext* context,
                                        const v1::CreateJobRequest* request,
                                        v1::Job* response) override {
      response->set_id("job of " + request->request_id());
      return Ended(context, farm_.Take(*request));
    }
    grpc::ServerUnaryReactor* GetJob(grpc::CallbackServerContext* context, const v1::GetJobRequest*,
                                     v1::Job*) override {
      grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
      farm_.EndOrHold(reactor);
      return reactor;
    }
    grpc::ServerWriteReactor<v1::JobEvent>* WatchJob(grpc::CallbackServerContext*,
                                                     const v1::WatchJobRequest* request) override {
      return new FakeStream(farm_.EventsOf(request->id()));
    }
    grpc::ServerWriteReactor<v1::DownloadResponse>* Download(grpc::CallbackServerContext*,
                                                             const v1::DownloadRequest*) override {
      std::vector<v1::DownloadResponse> chunks(2);
      chunks[0].set_data(farm_.gcode.substr(0, farm_.gcode.size() / 2));
      chunks[1].set_data(farm_.gcode.substr(farm_.gcode.size() / 2));
      return new FakeStream(std::move(chunks));
    }

   private:
    FakeFarm& farm_;
  };

  static grpc::ServerUnaryReactor* Ended(grpc::CallbackServerContext* context,
                                         const grpc::Status& status) {
    grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
    reactor->Finish(status);
    return reactor;
  }

  grpc::Status Take(const v1::CreateJobRequest& request) {
    const std::lock_guard lock(mutex_);
    if (refusals > 0) {
      --refusals;
      std::map<std::string, std::string> metadata;
      if (!retry_after.empty()) metadata[rpc::kRetryAfterMs] = retry_after;
      return rpc::ToGrpc(MakeError(absl::StatusCode::kResourceExhausted, Reason::kOverloaded,
                                   "too many", metadata));
    }
    if (!meshes.contains(request.spec().objects(0).mesh_sha256())) {
      return rpc::ToGrpc(
          MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBlobNotFound, "no mesh"));
    }
    created.push_back(request);
    return grpc::Status::OK;
  }

  void GoOn() {
    std::vector<grpc::ServerUnaryReactor*> to_end;
    {
      const std::lock_guard lock(mutex_);
      gets_to_hold_ = 0;
      to_end = std::exchange(held_, {});
    }
    for (grpc::ServerUnaryReactor* one : to_end) one->Finish(grpc::Status::OK);
  }

  void EndOrHold(grpc::ServerUnaryReactor* reactor) {
    {
      const std::lock_guard lock(mutex_);
      const bool hold = gets_to_hold_ > 0 && gets_before_-- <= 0;
      if (hold) held_.push_back(reactor);
      if (hold && static_cast<int>(held_.size()) < gets_to_hold_) return;
      if (hold) reactor = nullptr;
    }
    if (reactor != nullptr) return reactor->Finish(grpc::Status::OK);
    GoOn();
  }

  std::vector<v1::JobEvent> EventsOf(const std::string& id) const {
    std::vector<v1::JobEvent> events(kEvents);
    for (int i = 0; i < kEvents; ++i) {
      events[i].set_sequence(i + 1);
      *events[i].mutable_time() = google::protobuf::util::TimeUtil::GetCurrentTime();
      v1::Job& job = *events[i].mutable_job();
      job.set_id(id);
      job.set_state(i + 1 < kEvents ? v1::JOB_STATE_RUNNING : end_state);
      job.mutable_result()->set_gcode_sha256(gcode_sha256);
    }
    if (end_state == v1::JOB_STATE_FAILED) {
      v1::JobError& error = *events.back().mutable_job()->mutable_error();
      error.set_code(static_cast<int>(absl::StatusCode::kInternal));
      error.set_reason(std::string(ReasonName(Reason::kRangePoisoned)));
    }
    return events;
  }

  int port_ = 0;
  Jobs jobs_;
  std::mutex mutex_;
  int gets_before_ = 0;
  int gets_to_hold_ = 0;
  std::vector<grpc::ServerUnaryReactor*> held_;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace slicefarm::load
