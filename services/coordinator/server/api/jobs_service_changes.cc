// Methods of JobsService that change jobs.
#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/server/api/jobs_service.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/server/observe/job_log.h"

namespace slicefarm::coordinator {

grpc::Status JobsService::CancelJob(grpc::ServerContext* context,
                                    const v1::CancelJobRequest* request, v1::Job* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto job = Cancel(*caller, request->id());
  if (job.ok()) *response = ToProto(*job);
  return rpc::ToGrpc(job.status());
}

absl::StatusOr<JobRecord> JobsService::Cancel(const Caller& caller, const std::string& id) {
  const auto known = Find(caller, id, Of::kAllForAdmins);
  if (!known.ok()) return known;
  auto job = backend_.jobs.RequestCancel(id, backend_.now_us());
  if (!job.ok()) return job;
  backend_.log.Info("job cancelled", FieldsOf(*job));
  backend_.runner.Cancel(job->id);
  backend_.feed.Changed(job->id);
  backend_.feed.AddProgress(*job);
  job->spec = known->spec;
  return job;
}

grpc::Status JobsService::BatchCancelJobs(grpc::ServerContext* context,
                                          const v1::BatchCancelJobsRequest* request,
                                          v1::BatchCancelJobsResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->ids_size() > limits::kMaxPageSize) {
    return rpc::ToGrpc(LimitError(Reason::kRequestTooLarge, "jobs of a batch", limits::kMaxPageSize,
                                  request->ids_size()));
  }
  for (const std::string& id : request->ids()) {
    const auto job = Cancel(*caller, id);
    v1::BatchCancelJobsResponse::Outcome& outcome = *response->add_outcomes();
    if (job.ok()) {
      *outcome.mutable_job() = ToProto(*job);
      outcome.mutable_job()->clear_spec();
      outcome.mutable_job()->clear_labels();  // all jobs must fit into one message
    } else {
      *outcome.mutable_error() = ToProto(JobErrorOf(job.status()));
    }
  }
  return grpc::Status::OK;
}

grpc::Status JobsService::UpdateJob(grpc::ServerContext* context,
                                    const v1::UpdateJobRequest* request, v1::Job* response) {
  const auto known = Find(*context, {Scope::kSubmit}, request->id(), Of::kTenant);
  if (!known.ok()) return rpc::ToGrpc(known.status());
  const auto changing = FromProto(*request);
  if (!changing.ok()) return rpc::ToGrpc(changing.status());
  auto job = backend_.jobs.Change(request->id(), *changing, backend_.now_us());
  if (!job.ok()) return rpc::ToGrpc(job.status());
  backend_.feed.Changed(job->id);
  backend_.feed.AddProgress(*job);
  backend_.runner.Wake();  // another job may now be the first in the queue
  job->spec = known->spec;
  *response = ToProto(*job);
  return grpc::Status::OK;
}

}  // namespace slicefarm::coordinator
