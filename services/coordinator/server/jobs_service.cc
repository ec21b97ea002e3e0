#include "services/coordinator/server/jobs_service.h"

#include <fmt/format.h>

#include <utility>

#include "common/model/error.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/wire_error.h"
#include "services/coordinator/server/job_watch.h"
#include "services/coordinator/server/jobs_wire.h"
#include "services/coordinator/store/job_steps.h"

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

/// A watch that ends before it begins. Deletes itself.
class RefusedWatch final : public grpc::ServerWriteReactor<v1::JobEvent> {
 public:
  explicit RefusedWatch(const absl::Status& why) { Finish(rpc::ToGrpc(why)); }
  void OnDone() override { delete this; }
};

}  // namespace

/// The job, if the caller may know of it.
absl::StatusOr<JobRecord> JobsService::Find(const Caller& caller, const std::string& id, Of of) {
  auto job = backend_.jobs.Get(id);
  if (!job.ok() || job->tenant == caller.tenant) return job;
  if (of == Of::kAllForAdmins && caller.may(Scope::kAdmin)) return job;
  return JobNotFound(id);
}

absl::StatusOr<JobRecord> JobsService::Find(const grpc::ServerContextBase& context,
                                            const Scopes& one_of, const std::string& id, Of of) {
  const auto caller = backend_.callers.Find(context, one_of);
  if (!caller.ok()) return caller.status();
  return Find(*caller, id, of);
}

grpc::Status JobsService::CreateJob(grpc::ServerContext* context,
                                    const v1::CreateJobRequest* request, v1::Job* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto created = Create(*caller, *request);
  if (!created.ok()) {
    backend_.log.Warn("job refused", {{"tenant", caller->tenant},
                                      {"error", std::string(created.status().message())}});
    return rpc::ToGrpc(created.status());
  }
  *response = ToProto(created->job);
  if (!created->fresh) return grpc::Status::OK;
  backend_.log.Info("job accepted", {{"job", created->job.id}, {"tenant", caller->tenant}});
  backend_.runner.Wake();
  return grpc::Status::OK;
}

absl::StatusOr<Created> JobsService::Create(const Caller& caller,
                                            const v1::CreateJobRequest& request) {
  auto spec = FromProto(request.spec());
  if (!spec.ok()) return Within("spec", spec.status());
  return backend_.intake.Create({.tenant = caller.tenant,
                                 .max_open_jobs = caller.max_open_jobs,
                                 .request_id = request.request_id(),
                                 .spec = SpecBytes(request.spec()),
                                 .request = *std::move(spec),
                                 .labels = {request.labels().begin(), request.labels().end()}});
}

grpc::Status JobsService::GetJob(grpc::ServerContext* context, const v1::GetJobRequest* request,
                                 v1::Job* response) {
  const auto job = Find(*context, {Scope::kRead, Scope::kAdmin}, request->id(), Of::kAllForAdmins);
  if (job.ok()) *response = ToProto(*job);
  return rpc::ToGrpc(job.status());
}

grpc::Status JobsService::ListJobs(grpc::ServerContext* context, const v1::ListJobsRequest* request,
                                   v1::ListJobsResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  auto query = FromProto(*request);
  if (!query.ok()) return rpc::ToGrpc(query.status());
  query->tenant = caller->tenant;
  query->all_tenants = caller->may(Scope::kAdmin);
  const auto jobs = backend_.jobs.List(*query);
  if (jobs.ok()) *response = ToProto(*jobs, *query);
  return rpc::ToGrpc(jobs.status());
}

grpc::ServerWriteReactor<v1::JobEvent>* JobsService::WatchJob(grpc::CallbackServerContext* context,
                                                              const v1::WatchJobRequest* request) {
  const auto job = Find(*context, {Scope::kRead, Scope::kAdmin}, request->id(), Of::kAllForAdmins);
  if (!job.ok()) return new RefusedWatch(job.status());
  return new JobWatch(*context, backend_.jobs, backend_.feed, request->id(),
                      request->after_sequence());
}

grpc::Status JobsService::CancelJob(grpc::ServerContext* context,
                                    const v1::CancelJobRequest* request, v1::Job* response) {
  const auto known =
      Find(*context, {Scope::kSubmit, Scope::kAdmin}, request->id(), Of::kAllForAdmins);
  if (!known.ok()) return rpc::ToGrpc(known.status());
  const auto job = backend_.jobs.RequestCancel(request->id(), backend_.now_us());
  if (!job.ok()) return rpc::ToGrpc(job.status());
  backend_.log.Info("job cancelled", {{"job", job->id}});
  backend_.runner.Cancel(job->id);
  backend_.feed.Changed(job->id);
  *response = ToProto(*job);
  return grpc::Status::OK;
}

grpc::Status JobsService::DeleteJob(grpc::ServerContext* context,
                                    const v1::DeleteJobRequest* request, google::protobuf::Empty*) {
  const auto known = Find(*context, {Scope::kSubmit}, request->id(), Of::kTenant);
  if (!known.ok()) return rpc::ToGrpc(known.status());
  return rpc::ToGrpc(backend_.jobs.Delete(request->id()));
}

absl::StatusOr<std::unique_ptr<BlobReader>> JobsService::OpenArtifact(
    const Caller& caller, const v1::DownloadRequest& request) {
  const auto job = Find(caller, request.id(), Of::kTenant);
  if (!job.ok()) return job.status();
  const auto digest = ArtifactOf(*job, request.artifact());
  if (!digest.ok()) return digest.status();
  const auto blobs = backend_.blobs.Of(job->result->tenant);
  if (!blobs.ok()) return blobs.status();
  auto reader = (*blobs)->Open(*digest);
  if (!reader.ok()) return reader.status();
  if (request.offset() < 0 || request.offset() > (*reader)->size()) {
    return LimitError(Reason::kRequestMalformed, "offset", (*reader)->size(), request.offset());
  }
  return reader;
}

grpc::Status JobsService::Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                                   grpc::ServerWriter<v1::DownloadResponse>* stream) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(downloads_.Run(*context, [&](const Transfers::Moved& moved) {
    return Send(*caller, *request, moved, *stream);
  }));
}

absl::Status JobsService::Send(const Caller& caller, const v1::DownloadRequest& request,
                               const Transfers::Moved& moved,
                               grpc::ServerWriter<v1::DownloadResponse>& stream) {
  const auto reader = OpenArtifact(caller, request);
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
