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
#include "slicefarm/v1/presets.grpc.pb.h"
#include "slicefarm/v1/profiles.grpc.pb.h"

namespace slicefarm::cli {

/// Options of a JobsClient: server, security and time limits.
struct JobsClientOptions {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security = {};
  /// Time for which the server may be unreachable without interruption before a call fails.
  std::chrono::milliseconds patience{30'000};
  CancelToken cancel = {};  ///< ends calls with the error Cancelled
  /// Trace context of the calls and of the jobs that they create; empty: none.
  TraceContext trace = {};
};

/// Client for the services Meshes, Jobs, Profiles and Presets of a coordinator. Every call has a
/// deadline and is repeated while the server is unreachable. Uploads, downloads and watches
/// continue where they were interrupted.
///
/// Errors of all calls: the server's errors, with their reason; UNAVAILABLE with the server's
/// address after `patience`; Cancelled after an interrupt; errors of rpc::Secured.
class JobsClient {
 public:
  explicit JobsClient(JobsClientOptions options);

  /// Uploads a mesh: sends only the bytes that the server does not have. Calls `sent` with the
  /// number of bytes that the server has. Returns the mesh's SHA-256, which identifies it.
  absl::StatusOr<std::string> UploadMesh(std::string_view bytes,
                                         const std::function<void(int64_t)>& sent);

  /// Creates a job. The request gets an id, so that a repetition of the call creates no second job.
  absl::StatusOr<v1::Job> CreateJob(v1::CreateJobRequest request);
  /// Creates the jobs of several plates. A repetition of the call creates no further jobs.
  absl::StatusOr<v1::CreatePlatesResponse> CreatePlates(v1::CreatePlatesRequest request);
  /// Completes a shortened job id: returns the id that begins with `beginning`, among the newest
  /// 10,000 jobs. A text that does not have 4 to 31 hex digits is returned unchanged. Errors:
  /// JOB_NOT_FOUND; REQUEST_MALFORMED if several ids begin with the text.
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
  /// Returns the server's data about the caller: tenant, permissions and limits.
  absl::StatusOr<v1::GetCallerResponse> GetCaller();
  /// Returns the amount of data that the farm stores for a tenant.
  absl::StatusOr<v1::Usage> GetUsage(const v1::GetUsageRequest& request);
  /// Writes all data of a tenant to `file`, as a tar archive. After an interruption, the export
  /// begins again.
  absl::Status ExportTenant(const std::string& tenant, OutputFile& file);
  /// Erases all data of a tenant.
  absl::StatusOr<v1::EraseTenantResponse> EraseTenant(const std::string& tenant);
  /// Returns one page of jobs.
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request);

  /// Returns one page of meshes.
  absl::StatusOr<v1::ListMeshesResponse> ListMeshes(const v1::ListMeshesRequest& request);
  /// Deletes a mesh. Returns the server's answer.
  absl::StatusOr<bool> DeleteMesh(const std::string& sha256);
  /// Downloads a mesh to `file`. `file` is complete unless an error is returned. Errors: also
  /// BLOB_DIGEST_MISMATCH if the downloaded bytes do not have the digest `sha256`.
  absl::Status DownloadMesh(const std::string& sha256, OutputFile& file);

  /// Stores a revision of a profile.
  absl::StatusOr<v1::Profile> PutProfile(const v1::PutProfileRequest& request);
  /// Returns a revision of a profile.
  absl::StatusOr<v1::Profile> GetProfile(const v1::GetProfileRequest& request);
  /// Returns one page of profiles.
  absl::StatusOr<v1::ListProfilesResponse> ListProfiles(const v1::ListProfilesRequest& request);
  /// Deletes a profile, or one of its revisions.
  absl::Status DeleteProfile(const v1::DeleteProfileRequest& request);

  /// Methods of the service Presets.
  absl::StatusOr<v1::PresetBundle> ImportPresets(const v1::ImportPresetsRequest& request);
  absl::StatusOr<v1::PresetBundle> GetPresetBundle(const v1::GetPresetBundleRequest& request);
  absl::StatusOr<v1::ListPresetBundlesResponse> ListPresetBundles(
      const v1::ListPresetBundlesRequest& request);
  absl::StatusOr<v1::ListPresetsResponse> ListPresets(const v1::ListPresetsRequest& request);
  absl::StatusOr<v1::ResolvedPresets> ResolvePresets(const v1::ResolvePresetsRequest& request);
  absl::Status DeletePresetBundle(const v1::DeletePresetBundleRequest& request);

  /// Calls `changed` for each event of the job, including past events. Returns the job in its final
  /// state.
  absl::StatusOr<v1::Job> WatchJob(const std::string& id,
                                   const std::function<void(const v1::Job&)>& changed);

  /// Calls `on_response` for each event of all jobs. Ends when `on_response` returns an error, and
  /// returns this error. Continues after an interruption of the connection, so `on_response` gets
  /// some events twice.
  absl::Status WatchJobs(
      v1::WatchJobsRequest request,
      const std::function<absl::Status(const v1::WatchJobsResponse&)>& on_response);

  /// Downloads a result to `file`. `file` is complete unless an error is returned. Errors: also
  /// BLOB_DIGEST_MISMATCH if the digest differs from the one in `job.result()`. A trace is not
  /// checked, because `job.result()` does not have its digest.
  absl::Status Download(const v1::Job& job, v1::Artifact artifact, OutputFile& file);

  /// Returns a small result as text. Errors: as in Download.
  absl::StatusOr<std::string> DownloadText(const v1::Job& job, v1::Artifact artifact);

 private:
  using Attempt = std::function<absl::Status()>;
  absl::Status Persist(const Attempt& attempt);
  template <typename Response, typename Request, typename Start>
  absl::StatusOr<Response> Call(const Request& request, const Start& start,
                                std::chrono::milliseconds deadline = std::chrono::seconds(20));
  template <typename Request, typename Start>
  absl::Status DeleteOnce(const Request& request, const Start& start);
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
  std::unique_ptr<v1::Presets::Stub> presets_;
  Stopwatch clock_;
  bool answered_ = false;  ///< true if the server was reachable during the current attempt
};

}  // namespace slicefarm::cli
