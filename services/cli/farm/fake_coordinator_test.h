#pragma once

#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <grpcpp/support/server_callback.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/rpc/observe/trace_metadata.h"
#include "common/rpc/status_mapping.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::cli {

/// One WatchJob call: sends the events and ends. Without an end the stream stays open until it is
/// cancelled. Deletes itself.
class FakeWatch final : public grpc::ServerWriteReactor<v1::JobEvent> {
 public:
  FakeWatch(grpc::CallbackServerContext& context, std::vector<v1::JobEvent> events,
            std::optional<grpc::Status> end)
      : events_(std::move(events)), end_(std::move(end)) {
    context.AddInitialMetadata("slicefarm-watch", "open");
    StartSendInitialMetadata();
    Advance();
  }

  void OnWriteDone(bool ok) override {
    if (!ok) told_ = events_.size();
    Advance();
  }
  void OnCancel() override {
    if (!end_) Finish(grpc::Status::CANCELLED);
  }
  void OnDone() override { delete this; }

 private:
  void Advance() {
    if (told_ < events_.size()) {
      StartWrite(&events_[told_++]);
    } else if (end_) {
      Finish(*end_);
    }
  }

  const std::vector<v1::JobEvent> events_;
  const std::optional<grpc::Status> end_;  ///< only empty if there are no events
  size_t told_ = 0;
};

/// Coordinator for tests, as the client sees it. It breaks calls on request.
class FakeCoordinator : public v1::Meshes::Service,
                        public v1::Jobs::WithCallbackMethod_WatchJob<v1::Jobs::Service> {
 public:
  FakeCoordinator() {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(static_cast<v1::Meshes::Service*>(this));
    builder.RegisterService(static_cast<v1::Jobs::Service*>(this));
    server_ = builder.BuildAndStart();
  }
  ~FakeCoordinator() override { server_->Shutdown(std::chrono::system_clock::now()); }

  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

  // Values that tests set before a call or read after it.
  std::atomic<int> break_upload_after = -1;  ///< number of chunks; applies once
  grpc::Status upload_refused;  ///< unless OK, the error of each upload, and no bytes are kept
  std::atomic<int> break_watch_after = -1;  ///< number of events; applies once
  std::atomic<int> break_download_after = -1;
  std::deque<grpc::StatusCode> quiet_watch_ends;  ///< errors of watches that end before any event
  bool hold_watches = false;                  ///< watches send no events until they are cancelled
  std::deque<grpc::Status> refused_gets;      ///< first answers of GetJob
  bool forget_completion = false;             ///< reports a complete mesh as incomplete
  std::string mesh;                           ///< mesh of the current or last upload
  std::map<std::string, std::string> meshes;  ///< complete meshes, by digest
  std::vector<int64_t> upload_offsets;
  std::vector<int64_t> watch_sequences;
  std::vector<int64_t> download_offsets;
  std::set<std::string> request_ids;
  std::string result = std::string(300'000, 'g');
  v1::JobState end_state = v1::JOB_STATE_SUCCEEDED;
  v1::JobError end_error;
  v1::CreateJobRequest created;
  TraceContext trace;  ///< trace context of CreateJob
  std::string cancelled;
  v1::JobState state_after_cancel = v1::JOB_STATE_CANCELLED;
  std::atomic<int> watches = 0;
  int listed_jobs = 0;
  std::string waits_for;  ///< `waits_for` of created or listed jobs

  grpc::Status GetUpload(grpc::ServerContext*, const v1::GetUploadRequest* request,
                         v1::Upload* response) override {
    response->set_sha256(request->sha256());
    const std::string& held = Held(request->sha256());
    response->set_committed_size(static_cast<int64_t>(held.size()));
    response->set_complete(!forget_completion && Sha256Hex(held) == request->sha256());
    return grpc::Status::OK;
  }

  grpc::Status UploadMesh(grpc::ServerContext*, grpc::ServerReader<v1::UploadMeshRequest>* reader,
                          v1::Upload* response) override {
    if (!upload_refused.ok()) return upload_refused;
    v1::UploadMeshRequest chunk;
    int64_t size = 0;
    std::string digest;
    for (int i = 0; reader->Read(&chunk); ++i) {
      if (i == 0) {
        upload_offsets.push_back(chunk.write_offset());
        size = chunk.size();
        digest = chunk.sha256();
        mesh = std::string(Held(digest));
      }
      if (break_upload_after == i) {
        break_upload_after = -1;
        return Broken();
      }
      mesh += chunk.data();
    }
    if (Sha256Hex(mesh) == digest) meshes[digest] = mesh;
    response->set_committed_size(static_cast<int64_t>(mesh.size()));
    response->set_complete(static_cast<int64_t>(mesh.size()) == size);
    return grpc::Status::OK;
  }

  grpc::Status CreateJob(grpc::ServerContext* context, const v1::CreateJobRequest* request,
                         v1::Job* response) override {
    trace = rpc::TraceOf(*context);
    request_ids.insert(request->request_id());
    created = *request;
    response->set_id("job-1");
    response->set_state(v1::JOB_STATE_QUEUED);
    *response->mutable_spec() = request->spec();
    *response->mutable_labels() = request->labels();
    response->set_waits_for(waits_for);
    return grpc::Status::OK;
  }

  grpc::Status GetJob(grpc::ServerContext*, const v1::GetJobRequest* request,
                      v1::Job* response) override {
    if (!refused_gets.empty()) {
      const grpc::Status refused = refused_gets.front();
      refused_gets.pop_front();
      return refused;
    }
    response->set_id("job-1");
    return Find(request->id());
  }

  grpc::Status CancelJob(grpc::ServerContext*, const v1::CancelJobRequest* request,
                         v1::Job* response) override {
    cancelled = request->id();
    response->set_id("job-1");
    response->set_state(state_after_cancel);
    return Find(request->id());
  }

  grpc::Status DeleteJob(grpc::ServerContext*, const v1::DeleteJobRequest* request,
                         google::protobuf::Empty*) override {
    return Find(request->id());
  }

  grpc::Status ListJobs(grpc::ServerContext*, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override {
    int next = request->page_token().empty() ? 0 : std::stoi(request->page_token());
    const int end = std::min(next + request->page_size(), listed_jobs);
    for (; next < end; ++next) {
      v1::Job& job = *response->add_jobs();
      job.set_id("job-" + std::to_string(next));
      if (next > 0) job.set_waits_for(waits_for);
    }
    if (next < listed_jobs) response->set_next_page_token(std::to_string(next));
    return grpc::Status::OK;
  }

  grpc::ServerWriteReactor<v1::JobEvent>* WatchJob(grpc::CallbackServerContext* context,
                                                   const v1::WatchJobRequest* request) override {
    watch_sequences.push_back(request->after_sequence());
    std::optional<grpc::Status> end = grpc::Status::OK;
    std::vector<v1::JobEvent> events;
    if (!quiet_watch_ends.empty()) {
      end = grpc::Status(quiet_watch_ends.front(), "before any event");
      quiet_watch_ends.pop_front();
    } else if (hold_watches) {
      end = std::nullopt;
    } else {
      events = EventsAfter(*request);
      if (break_watch_after >= 0 && break_watch_after < static_cast<int>(events.size())) {
        events.resize(break_watch_after.exchange(-1));
        end = Broken();
      }
    }
    ++watches;
    return new FakeWatch(*context, std::move(events), end);
  }

  grpc::Status Download(grpc::ServerContext*, const v1::DownloadRequest* request,
                        grpc::ServerWriter<v1::DownloadResponse>* writer) override {
    download_offsets.push_back(request->offset());
    constexpr size_t kChunk = 64 << 10;
    int written = 0;
    for (size_t at = request->offset(); at < result.size(); at += kChunk) {
      if (break_download_after == written++) {
        break_download_after = -1;
        return Broken();
      }
      v1::DownloadResponse response;
      response.set_data(result.substr(at, kChunk));
      writer->Write(response);
    }
    return grpc::Status::OK;
  }

 private:
  /// Returns the stored bytes of a mesh: the complete mesh, or the last upload unless it is another
  /// complete mesh.
  const std::string& Held(const std::string& digest) const {
    static const std::string kNothing;
    const auto whole = meshes.find(digest);
    if (whole != meshes.end()) return whole->second;
    return meshes.contains(Sha256Hex(mesh)) ? kNothing : mesh;
  }

  static grpc::Status Broken() { return {grpc::StatusCode::UNAVAILABLE, "the connection broke"}; }

  std::vector<v1::JobEvent> EventsAfter(const v1::WatchJobRequest& request) const {
    constexpr int kEvents = 5;
    std::vector<v1::JobEvent> events;
    for (int64_t sequence = request.after_sequence() + 1; sequence <= kEvents; ++sequence) {
      v1::JobEvent& event = events.emplace_back();
      event.set_sequence(sequence);
      v1::Job& job = *event.mutable_job();
      job.set_id(request.id());
      job.set_state(sequence < kEvents ? v1::JOB_STATE_RUNNING : end_state);
      job.mutable_progress()->set_layers_done(static_cast<int>(sequence));
      if (job.state() == v1::JOB_STATE_FAILED) *job.mutable_error() = end_error;
    }
    return events;
  }

  static grpc::Status Find(const std::string& id) {
    if (id == "job-1") return grpc::Status::OK;
    return rpc::ToGrpc(
        MakeError(absl::StatusCode::kNotFound, Reason::kJobNotFound, "there is no job " + id));
  }

  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace slicefarm::cli
