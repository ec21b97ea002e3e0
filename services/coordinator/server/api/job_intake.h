#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "common/base/cancel_token.h"
#include "common/base/trace_context.h"
#include "common/model/limits.h"
#include "services/coordinator/server/api/full_queues.h"
#include "services/coordinator/server/api/tenant_budgets.h"
#include "services/coordinator/server/api/tenant_slot_queue.h"
#include "services/coordinator/server/execution/disk_guard.h"
#include "services/coordinator/server/execution/job_results.h"
#include "services/coordinator/server/execution/resolved_jobs.h"
#include "services/coordinator/server/messages/job_request.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Request for a job, with its tenant and the limits of the tenant.
struct Submission {
  std::string tenant = {};
  int64_t max_open_jobs = limits::kMaxOpenJobs;  ///< largest number of open jobs of the tenant
  int64_t max_kept_jobs = INT64_MAX;             ///< largest number of stored jobs of the tenant
  int64_t max_kept_bytes = INT64_MAX;            ///< largest number of stored bytes of the tenant
  std::string request_id;                        ///< already checked
  /// Digest of the request as received; two requests with equal content have equal digests.
  std::string spec_digest;
  std::string spec;  ///< request in the form that is stored
  JobRequest request;
  std::map<std::string, std::string> labels;
  Priority priority = Priority::kNormal;
  int64_t deadline_us = kNoDeadlineUs;
  std::string webhook_url = {};
  /// Trace context of the call; if empty, the job begins a trace of its own.
  TraceContext trace = {};
};

/// Creates jobs from requests and makes all checks of them. No later code checks a request again.
class JobIntake {
 public:
  JobIntake(JobStore& jobs, BlobStores& blobs, const DiskGuard& disk, TenantBudgets& budgets,
            FullQueues& full_queues, ResolvedJobs& resolved, std::string build_id,
            ResultSharing sharing, std::function<int64_t()> now_us,
            ProcessSet processes = ProcessSet::All())
      : jobs_(jobs),
        blobs_(blobs),
        disk_(disk),
        budgets_(budgets),
        full_queues_(full_queues),
        resolved_(resolved),
        build_id_(std::move(build_id)),
        sharing_(sharing),
        now_us_(std::move(now_us)),
        processes_(processes) {}

  /// Creates a job. Returns when the job is on disk. Errors: see ResolveJob, DiskGuard,
  /// TenantBudgets and JobStore::Create; the error of `cancel`; BLOB_NOT_FOUND (FailedPrecondition,
  /// metadata `sha256`) for a mesh that the tenant has not uploaded; PROCESS_UNAVAILABLE
  /// (FailedPrecondition) for a process that this farm does not support.
  absl::StatusOr<Created> Create(Submission submission, const CancelToken& cancel = {});

  /// Creates all jobs or none. Errors: the first error, as in Create.
  absl::StatusOr<std::vector<Created>> CreateAll(std::vector<Submission> submissions,
                                                 const CancelToken& cancel = {});

  /// Returns the jobs that an earlier call with these request ids created. `spec_digest`: digest of
  /// the present call. Deleted jobs are missing. Errors: REQUEST_ID_REUSED if the earlier call had
  /// another digest.
  absl::StatusOr<std::vector<JobRecord>> FindAll(const std::string& tenant,
                                                 const std::vector<std::string>& request_ids,
                                                 const std::string& spec_digest) {
    return jobs_.FindRequested(tenant, request_ids, spec_digest);
  }

  /// Makes all checks of Create, and returns the resolved job without storing it.
  absl::StatusOr<std::shared_ptr<const ResolvedJob>> Check(const Submission& submission,
                                                           const CancelToken& cancel);

  /// Returns the build that would make the job.
  const std::string& build_id() const { return build_id_; }

 private:
  static constexpr int kWritesAtOnce = 8;  ///< number of store connections for callers

  absl::StatusOr<Created> EarlierOr(const Submission& submission, const absl::Status& refusal);
  absl::StatusOr<NewJob> NewJobOf(Submission submission, const CancelToken& cancel);
  absl::Status CheckMeshes(const std::string& tenant, const ResolvedJob& job);

  JobStore& jobs_;
  BlobStores& blobs_;
  const DiskGuard& disk_;
  TenantBudgets& budgets_;
  FullQueues& full_queues_;
  ResolvedJobs& resolved_;
  const std::string build_id_;
  const ResultSharing sharing_;
  const std::function<int64_t()> now_us_;
  const ProcessSet processes_;
  /// Slots for writing to the store, so that no caller waits for all writes of another tenant.
  TenantSlotQueue write_slots_{kWritesAtOnce};
};

/// Returns an unpredictable id of 32 hex digits. Aborts if there is no source of randomness.
std::string NewJobId();

}  // namespace slicefarm::coordinator
