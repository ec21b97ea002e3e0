#pragma once

#include <functional>

#include "common/rpc/json_log.h"
#include "services/coordinator/server/callers.h"
#include "services/coordinator/server/job_feed.h"
#include "services/coordinator/server/job_intake.h"
#include "services/coordinator/server/job_runner.h"
#include "services/coordinator/server/transfers.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// What the service speaks for. Everything outlives it.
struct JobsBackend {
  const Callers& callers;
  JobStore& jobs;
  BlobStores& blobs;
  JobIntake& intake;
  JobRunner& runner;
  JobFeed& feed;
  std::function<int64_t()> now_us;
  rpc::JsonLog log;
};

/// Translates slicefarm.v1.Jobs. A job of another tenant is, to its callers, one that does not
/// exist.
class JobsService final : public v1::Jobs::WithCallbackMethod_WatchJob<v1::Jobs::Service> {
 public:
  JobsService(JobsBackend backend, const TransferOptions& options)
      : backend_(std::move(backend)), downloads_(options) {}

  grpc::Status CreateJob(grpc::ServerContext* context, const v1::CreateJobRequest* request,
                         v1::Job* response) override;
  grpc::Status GetJob(grpc::ServerContext* context, const v1::GetJobRequest* request,
                      v1::Job* response) override;
  grpc::Status ListJobs(grpc::ServerContext* context, const v1::ListJobsRequest* request,
                        v1::ListJobsResponse* response) override;
  grpc::ServerWriteReactor<v1::JobEvent>* WatchJob(grpc::CallbackServerContext* context,
                                                   const v1::WatchJobRequest* request) override;
  grpc::Status CancelJob(grpc::ServerContext* context, const v1::CancelJobRequest* request,
                         v1::Job* response) override;
  grpc::Status DeleteJob(grpc::ServerContext* context, const v1::DeleteJobRequest* request,
                         google::protobuf::Empty* response) override;
  grpc::Status Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                        grpc::ServerWriter<v1::DownloadResponse>* stream) override;

 private:
  enum class Of { kTenant, kAllForAdmins };
  absl::StatusOr<Created> Create(const Caller& caller, const v1::CreateJobRequest& request);
  absl::StatusOr<JobRecord> Find(const Caller& caller, const std::string& id, Of of);
  absl::StatusOr<JobRecord> Find(const grpc::ServerContextBase& context, const Scopes& one_of,
                                 const std::string& id, Of of);
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenArtifact(const Caller& caller,
                                                           const v1::DownloadRequest& request);
  absl::Status Send(const Caller& caller, const v1::DownloadRequest& request,
                    const Transfers::Moved& moved,
                    grpc::ServerWriter<v1::DownloadResponse>& stream);

  JobsBackend backend_;
  Transfers downloads_;
};

}  // namespace slicefarm::coordinator
