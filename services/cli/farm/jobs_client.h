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

/// Connection of a JobsClient.
struct JobsClientOptions {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security = {};
  /// Time that the server may be unreachable without interruption before a call fails.
  std::chrono::milliseconds patience{30'000};
  CancelToken cancel = {};  ///< ends calls with the error Cancelled
  TraceContext trace = {};  ///< trace of the calls and of a job that they make; empty: none
};

/// Client for Meshes, Jobs and Profiles of a coordinator. Every call has a deadline and is repeated
/// while the server is unreachable. Uploads, downloads and watches continue where they were
/// interrupted.
/// Errors of all calls: the server's errors, with their reason; UNAVAILABLE naming the server after
/// `patience`; Cancelled after an interrupt; as rpc::Secured.
class JobsClient {
 public:
  explicit JobsClient(JobsClientOptions options);

  /// Sends the bytes that the server lacks; none if it has them all. Calls `sent` with the number
  /// of bytes on the server. Returns the SHA-256 that identifies the mesh.
  absl::StatusOr<std::string> UploadMesh(std::string_view bytes,
                                         const std::function<void(int64_t)>& sent);

  /// Creates a job. The request has an id, so a repeated call makes no second job.
  absl::StatusOr<v1::Job> CreateJob(v1::CreateJobRequest request);
  /// Creates the jobs of several plates. A repeated call makes no more jobs.
  absl::StatusOr<v1::CreatePlatesResponse> CreatePlates(v1::CreatePlatesRequest request);
  /// Returns the job id that begins with `beginning`, among the newest 10,000 jobs. Text other than
  /// 4 to 31 hex digits is returned unchanged. Errors: JOB_NOT_FOUND; REQUEST_MALFORMED if several
  /// ids match.
  absl::StatusOr<std::string> FullId(const std::string& beginning);

  /// Returns a job.
  absl::StatusOr<v1::Job> GetJob(const std::string& id, v1::JobView view = v1::JOB_VIEW_FULL);
  /// Requests the cancellation of a job and returns its state.
  absl::StatusOr<v1::Job> CancelJob(const std::string& id);
  /// Deletes a job that ended, with its results.
  absl::Status DeleteJob(const std::string& id);
  /// Cancels at most 1000 jobs, independently of each other.
  absl::StatusOr<v1::BatchCancelJobsResponse> CancelJobs(const v1::BatchCancelJobsRequest& request);
  /// Changes properties of a job and returns it.
  absl::StatusOr<v1::Job> UpdateJob(const v1::UpdateJobRequest& request);
  /// Returns the webhook of a job.
  absl::StatusOr<v1::Webhook> GetWebhook(const std::string& job_id);
  /// Returns the stored results of a job.
  absl::StatusOr<v1::ListArtifactsResponse> ListArtifacts(const std::string& job_id);
  /// Returns the server's data about the caller.
  absl::StatusOr<v1::GetCallerResponse> GetCaller();
  /// Returns the usage of the farm.
  absl::StatusOr<v1::Usage> GetUsage(const v1::GetUsageRequest& request);
  /// Writes all data of a tenant to `file`, as a tar archive. An interrupted export begins again.
  absl::Status ExportTenant(const std::string& tenant, OutputFile& file);
  /// Erases all data of a tenant.
  absl::StatusOr<v1::EraseTenantResponse> EraseTenant(const std::string& tenant);
  /// Returns one page of jobs.
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request);

  /// Returns one page of meshes.
  absl::StatusOr<v1::ListMeshesResponse> ListMeshes(const v1::ListMeshesRequest& request);
  /// Deletes a mesh. Returns the server's answer.
  absl::StatusOr<bool> DeleteMesh(const std::string& sha256);
  /// Writes a mesh to `file`, completely or with an error. Errors: also BLOB_DIGEST_MISMATCH.
  absl::Status DownloadMesh(const std::string& sha256, OutputFile& file);

  /// Stores a profile, gets one, lists them, or deletes one.
  absl::StatusOr<v1::Profile> PutProfile(const v1::PutProfileRequest& request);
  absl::StatusOr<v1::Profile> GetProfile(const v1::GetProfileRequest& request);
  absl::StatusOr<v1::ListProfilesResponse> ListProfiles(const v1::ListProfilesRequest& request);
  absl::Status DeleteProfile(const v1::DeleteProfileRequest& request);

  /// Calls `changed` for each event of the job, past ones included. Returns the job in its final
  /// state.
  absl::StatusOr<v1::Job> WatchJob(const std::string& id,
                                   const std::function<void(const v1::Job&)>& changed);

  /// Calls `told` for events of all jobs, until `told` returns an error, which is returned.
  /// Continues after an interruption, so some events come twice.
  absl::Status WatchJobs(v1::WatchJobsRequest request,
                         const std::function<absl::Status(const v1::WatchJobsResponse&)>& told);

  /// Writes a result to `file`, completely or with an error. Errors: also BLOB_DIGEST_MISMATCH if
  /// it differs from `job.result()`. A trace is not in `job.result()`, so it is not checked.
  absl::Status Download(const v1::Job& job, v1::Artifact artifact, OutputFile& file);

  /// Returns a small result as text. Errors: as Download.
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
  bool answered_ = false;  ///< true if the server was reachable during the current attempt
};

}  // namespace slicefarm::cli
