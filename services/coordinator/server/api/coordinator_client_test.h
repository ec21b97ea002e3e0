#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/sha256.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/observe/trace_metadata.h"
#include "common/rpc/status_mapping.h"
#include "slicefarm/v1/jobs.grpc.pb.h"
#include "slicefarm/v1/presets.grpc.pb.h"
#include "slicefarm/v1/profiles.grpc.pb.h"

namespace slicefarm::coordinator {

/// Client of the coordinator for tests. Sends meshes and waits for the ends of their jobs. Makes
/// one call at a time, without retries.
class CoordinatorClient {
 public:
  void Connect(const std::string& address) {
    Use(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
  }

  /// Connects with the given credentials: a token or a certificate.
  void Connect(const std::string& address, rpc::ChannelOptions options) {
    options.retries = false;
    options.own_connection = true;
    Use(rpc::MakeChannel(address, options));
  }

  /// Sends all further calls over this channel.
  void Use(const std::shared_ptr<grpc::Channel>& channel) {
    channel_ = channel;
    jobs_ = v1::Jobs::NewStub(channel);
    meshes_ = v1::Meshes::NewStub(channel);
    profiles_ = v1::Profiles::NewStub(channel);
    presets_ = v1::Presets::NewStub(channel);
  }

  /// Sends the bytes [from, to) of a mesh; `to` -1 means its end. `digest`: name of the upload; by
  /// default the mesh's own digest.
  absl::StatusOr<v1::Upload> Upload(const std::string& bytes, int64_t from = 0, int64_t to = -1,
                                    const std::string& digest = "") {
    grpc::ClientContext context;
    v1::Upload upload;
    const auto stream = meshes_->UploadMesh(&context, &upload);
    const int64_t end = to < 0 ? std::ssize(bytes) : to;
    v1::UploadMeshRequest request;
    request.set_sha256(digest.empty() ? Sha256Hex(bytes) : digest);
    request.set_size(std::ssize(bytes));
    request.set_write_offset(from);
    int64_t at = from;
    do {
      request.set_data(bytes.substr(at, std::min<int64_t>(65'536, end - at)));
      if (!stream->Write(request)) break;
      request.Clear();
      at += 65'536;
    } while (at < end);
    stream->WritesDone();
    const absl::Status status = rpc::FromGrpc(stream->Finish());
    if (!status.ok()) return status;
    return upload;
  }

  /// Returns the state of an upload.
  v1::Upload GetUpload(const std::string& digest) {
    grpc::ClientContext context;
    v1::GetUploadRequest request;
    request.set_sha256(digest);
    v1::Upload upload;
    EXPECT_TRUE(meshes_->GetUpload(&context, request, &upload).ok());
    return upload;
  }

  /// Returns a job.
  absl::StatusOr<v1::Job> Get(const std::string& id) {
    v1::GetJobRequest request;
    request.set_id(id);
    v1::Job job;
    grpc::ClientContext context;
    const absl::Status status = rpc::FromGrpc(jobs_->GetJob(&context, request, &job));
    if (!status.ok()) return status;
    return job;
  }

  /// Returns a request for a job with this mesh.
  static v1::CreateJobRequest RequestFor(const std::string& mesh) {
    v1::CreateJobRequest request;
    v1::Object* object = request.mutable_spec()->add_objects();
    object->set_mesh_sha256(Sha256Hex(mesh));
    object->set_name("part.stl");
    // The default settings of the services are sufficient.
    request.mutable_spec()->set_generic(true);
    return request;
  }

  /// Creates a job.
  absl::StatusOr<v1::Job> Create(const v1::CreateJobRequest& request,
                                 const TraceContext& trace = {}) {
    grpc::ClientContext context;
    rpc::SetTrace(trace, &context);
    v1::Job job;
    const absl::Status status = rpc::FromGrpc(jobs_->CreateJob(&context, request, &job));
    if (!status.ok()) return status;
    return job;
  }

  /// Uploads the mesh and creates a job with it. Returns the id of the job.
  std::string Submit(const std::string& mesh) {
    EXPECT_TRUE(Upload(mesh).ok());
    const auto job = Create(RequestFor(mesh));
    EXPECT_TRUE(job.ok()) << job.status();
    return job.ok() ? job->id() : "";
  }

  /// Returns the ids of the jobs on the first page.
  std::vector<std::string> List(const v1::ListJobsRequest& request = {}) {
    grpc::ClientContext context;
    v1::ListJobsResponse response;
    EXPECT_TRUE(jobs_->ListJobs(&context, request, &response).ok());
    std::vector<std::string> ids;
    for (const v1::Job& job : response.jobs()) ids.push_back(job.id());
    return ids;
  }

  /// Returns the events after `after`, up to the end of the stream.
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

  /// Returns the result without the shares of objects, which events do not have.
  static v1::JobResult WithoutShares(v1::JobResult result) {
    result.clear_objects();
    result.clear_shared();
    return result;
  }

  /// Returns the ended job. Checks that the last event reports the same state.
  v1::Job AwaitEnd(const std::string& id) {
    absl::Status end;
    const std::vector<v1::JobEvent> events = Watch(id, 0, &end);
    EXPECT_TRUE(end.ok()) << end;
    const v1::Job reported = events.empty() ? v1::Job() : events.back().job();
    const absl::StatusOr<v1::Job> job = Get(id);
    EXPECT_TRUE(job.ok()) << job.status();
    if (!job.ok()) return {};
    EXPECT_EQ(reported.state(), job->state());
    EXPECT_EQ(reported.result().SerializeAsString(),
              WithoutShares(job->result()).SerializeAsString());
    return *job;
  }

  /// Returns the bytes of an artifact.
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

  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
  std::unique_ptr<v1::Meshes::Stub> meshes_;
  std::unique_ptr<v1::Profiles::Stub> profiles_;
  std::unique_ptr<v1::Presets::Stub> presets_;
};

}  // namespace slicefarm::coordinator
