#pragma once

#include <grpcpp/channel.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/base/stopwatch.h"
#include "common/base/trace_context.h"
#include "common/rpc/client/client_security.h"
#include "services/cli/console/files.h"
#include "slicefarm/v1/jobs.grpc.pb.h"
#include "slicefarm/v1/profiles.grpc.pb.h"

namespace slicefarm::cli {

struct JobsClientOptions {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security = {};
  /// How long the server may be out of reach at a stretch before that is an error.
  std::chrono::milliseconds patience{30'000};
  CancelToken cancel = {};  ///< ends calls as Cancelled
  TraceContext trace = {};  ///< that the calls, and a job they make, belong to; empty: none
};

/// Meshes, Jobs and Profiles of a coordinator. Every call has a deadline and is made again while
/// the server is out of reach; uploads, downloads and watches go on where they broke off. Errors:
/// the server's, with their reason; UNAVAILABLE naming the server after `patience`; Cancelled after
/// an interrupt; those of rpc::Secured, by every call.
class JobsClient {
 public:
  explicit JobsClient(JobsClientOptions options);

  /// Sends what the server lacks of the bytes; nothing if it has them. `sent` is told how many
  /// bytes are there. Returns the SHA-256 by which the mesh goes.
  absl::StatusOr<std::string> UploadMesh(std::string_view bytes,
                                         const std::function<void(int64_t)>& sent);

  /// With a request id, so that a repeated call makes no second job.
  absl::StatusOr<v1::Job> CreateJob(v1::CreateJobRequest request);
  /// The same for as many jobs as there are plates.
  absl::StatusOr<v1::CreatePlatesResponse> CreatePlates(v1::CreatePlatesRequest request);
  /// The id that begins so, of the newest 10,000 jobs. What is no beginning (4 to 31 hex digits)
  /// comes back as it is. Errors: JOB_NOT_FOUND; REQUEST_MALFORMED if several begin so.
  absl::StatusOr<std::string> FullId(const std::string& beginning);

  absl::StatusOr<v1::Job> GetJob(const std::string& id, v1::JobView view = v1::JOB_VIEW_FULL);
  absl::StatusOr<v1::Job> CancelJob(const std::string& id);
  absl::Status DeleteJob(const std::string& id);
  /// Of at most 1000 jobs, each by itself.
  absl::StatusOr<v1::BatchCancelJobsResponse> CancelJobs(const v1::BatchCancelJobsRequest& request);
  absl::StatusOr<v1::Job> UpdateJob(const v1::UpdateJobRequest& request);
  absl::StatusOr<v1::Webhook> GetWebhook(const std::string& job_id);
  absl::StatusOr<v1::ListArtifactsResponse> ListArtifacts(const std::string& job_id);
  absl::StatusOr<v1::GetCallerResponse> GetCaller();
  absl::StatusOr<v1::Usage> GetUsage(const v1::GetUsageRequest& request);
  /// Writes all that is kept of a tenant to `file`, a tar archive; what breaks off begins anew.
  absl::Status ExportTenant(const std::string& tenant, OutputFile& file);
  absl::StatusOr<v1::EraseTenantResponse> EraseTenant(const std::string& tenant);
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request);

  absl::StatusOr<v1::ListMeshesResponse> ListMeshes(const v1::ListMeshesRequest& request);
  absl::StatusOr<bool> DeleteMesh(const std::string& sha256);
  /// Writes it to `file`, as a whole or with an error. Errors: also BLOB_DIGEST_MISMATCH.
  absl::Status DownloadMesh(const std::string& sha256, OutputFile& file);

  absl::StatusOr<v1::Profile> PutProfile(const v1::PutProfileRequest& request);
  absl::StatusOr<v1::Profile> GetProfile(const v1::GetProfileRequest& request);
  absl::StatusOr<v1::ListProfilesResponse> ListProfiles(const v1::ListProfilesRequest& request);
  absl::Status DeleteProfile(const v1::DeleteProfileRequest& request);

  /// Tells each event of the job, those of the past too, and returns the job as it ended.
  absl::StatusOr<v1::Job> WatchJob(const std::string& id,
                                   const std::function<void(const v1::Job&)>& changed);

  /// Tells what happens to all jobs, until `told` returns an error, which is returned. Goes on
  /// where it broke off: some events come twice.
  absl::Status WatchJobs(v1::WatchJobsRequest request,
                         const std::function<absl::Status(const v1::WatchJobsResponse&)>& told);

  /// Writes a result to `file`, as a whole or with an error. Errors: also BLOB_DIGEST_MISMATCH if
  /// it is not what `job.result()` says; a trace, of which that says nothing, is taken as it comes.
  absl::Status Download(const v1::Job& job, v1::Artifact artifact, OutputFile& file);

  /// The same, in memory: for what is small.
  absl::StatusOr<std::string> DownloadText(const v1::Job& job, v1::Artifact artifact);

 private:
  using Attempt = std::function<absl::Status()>;
  absl::Status Persist(const Attempt& attempt);
  template <typename Response, typename Request, typename Start>
  absl::StatusOr<Response> Call(const Request& request, const Start& start,
                                std::chrono::milliseconds deadline = std::chrono::seconds(20));
  using Write = std::function<absl::Status(std::string_view)>;
  absl::Status Receive(const v1::Job& job, v1::Artifact artifact, const Write& write);
  absl::Status SendFrom(int64_t offset, const std::string& sha256, std::string_view bytes,
                        const std::function<void(int64_t)>& sent);

  const JobsClientOptions options_;
  const absl::StatusOr<rpc::ChannelOptions> connection_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::Meshes::Stub> meshes_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
  std::unique_ptr<v1::Profiles::Stub> profiles_;
  Stopwatch clock_;
  bool answered_ = false;  ///< the server was in reach during the current attempt
};

}  // namespace slicefarm::cli
