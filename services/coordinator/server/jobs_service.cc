#include "services/coordinator/server/jobs_service.h"

#include <fmt/format.h>

#include <utility>

#include "common/model/error.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/wire_error.h"
#include "services/coordinator/server/job_watch.h"
#include "services/coordinator/server/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kDownloadChunkBytes = 64 << 10;

absl::StatusOr<std::string> ArtifactOf(const JobRecord& job, v1::Artifact artifact) {
  if (!job.result) {
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kJobNotFinished,
                     fmt::format("job {} has no result: it is {}", job.id, JobStateName(job.state)),
                     {{"job", job.id}, {"state", std::string(JobStateName(job.state))}});
  }
  switch (artifact) {
    case v1::ARTIFACT_GCODE:
      return job.result->gcode_sha256;
    case v1::ARTIFACT_REPORT:
      return job.result->report_sha256;
    default:
      return Malformed("artifact", "is none of this version");
  }
}

}  // namespace

grpc::Status JobsService::CreateJob(grpc::ServerContext*, const v1::CreateJobRequest* request,
                                    v1::Job* response) {
  const auto created = Create(*request);
  if (!created.ok()) {
    backend_.log.Warn("job refused", {{"error", std::string(created.status().message())}});
    return rpc::ToGrpc(created.status());
  }
  *response = ToProto(created->job);
  if (!created->fresh) return grpc::Status::OK;
  backend_.log.Info("job accepted", {{"job", created->job.id}});
  backend_.runner.Wake();
  return grpc::Status::OK;
}

absl::StatusOr<Created> JobsService::Create(const v1::CreateJobRequest& request) {
  auto spec = FromProto(request.spec());
  if (!spec.ok()) return Within("spec", spec.status());
  return backend_.intake.Create({.request_id = request.request_id(),
                                 .spec = SpecBytes(request.spec()),
                                 .request = *std::move(spec),
                                 .labels = {request.labels().begin(), request.labels().end()}});
}

grpc::Status JobsService::GetJob(grpc::ServerContext*, const v1::GetJobRequest* request,
                                 v1::Job* response) {
  const auto job = backend_.jobs.Get(request->id());
  if (job.ok()) *response = ToProto(*job);
  return rpc::ToGrpc(job.status());
}

grpc::Status JobsService::ListJobs(grpc::ServerContext*, const v1::ListJobsRequest* request,
                                   v1::ListJobsResponse* response) {
  const auto query = FromProto(*request);
  if (!query.ok()) return rpc::ToGrpc(query.status());
  const auto jobs = backend_.jobs.List(*query);
  if (jobs.ok()) *response = ToProto(*jobs, *query);
  return rpc::ToGrpc(jobs.status());
}

grpc::ServerWriteReactor<v1::JobEvent>* JobsService::WatchJob(grpc::CallbackServerContext* context,
                                                              const v1::WatchJobRequest* request) {
  return new JobWatch(*context, backend_.jobs, backend_.feed, request->id(),
                      request->after_sequence());
}

grpc::Status JobsService::CancelJob(grpc::ServerContext*, const v1::CancelJobRequest* request,
                                    v1::Job* response) {
  const auto job = backend_.jobs.RequestCancel(request->id(), backend_.now_us());
  if (!job.ok()) return rpc::ToGrpc(job.status());
  backend_.log.Info("job cancelled", {{"job", job->id}});
  backend_.runner.Cancel(job->id);
  backend_.feed.Changed(job->id);
  *response = ToProto(*job);
  return grpc::Status::OK;
}

grpc::Status JobsService::DeleteJob(grpc::ServerContext*, const v1::DeleteJobRequest* request,
                                    google::protobuf::Empty*) {
  return rpc::ToGrpc(backend_.jobs.Delete(request->id()));
}

absl::StatusOr<std::unique_ptr<BlobReader>> JobsService::OpenArtifact(
    const v1::DownloadRequest& request) {
  const auto job = backend_.jobs.Get(request.id());
  if (!job.ok()) return job.status();
  const auto digest = ArtifactOf(*job, request.artifact());
  if (!digest.ok()) return digest.status();
  auto reader = backend_.blobs.Open(*digest);
  if (!reader.ok()) return reader.status();
  if (request.offset() < 0 || request.offset() > (*reader)->size()) {
    return LimitError(Reason::kRequestMalformed, "offset", (*reader)->size(), request.offset());
  }
  return reader;
}

grpc::Status JobsService::Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                                   grpc::ServerWriter<v1::DownloadResponse>* stream) {
  return rpc::ToGrpc(downloads_.Run(
      *context, [&](const Transfers::Moved& moved) { return Send(*request, moved, *stream); }));
}

absl::Status JobsService::Send(const v1::DownloadRequest& request, const Transfers::Moved& moved,
                               grpc::ServerWriter<v1::DownloadResponse>& stream) {
  const auto reader = OpenArtifact(request);
  if (!reader.ok()) return reader.status();
  v1::DownloadResponse response;
  for (int64_t at = request.offset(); at < (*reader)->size(); at += kDownloadChunkBytes) {
    auto bytes = (*reader)->Read(at, kDownloadChunkBytes);
    if (!bytes.ok()) return bytes.status();
    response.set_data(*std::move(bytes));
    if (!stream.Write(response)) break;  // the client left
    moved();
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
