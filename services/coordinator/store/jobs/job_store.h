#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/queue_order.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// Job to be created.
struct NewJob {
  std::string id;
  std::string tenant;
  /// Unique within the tenant; empty: each repetition of the call creates another job.
  std::string request_id;
  std::string spec_digest;  ///< digest of the request; equal requests have equal digests
  std::string spec;
  std::map<std::string, std::string> labels;
  Priority priority = Priority::kNormal;
  int64_t deadline_us = kNoDeadlineUs;
  std::vector<std::string> inputs;  ///< digests of the blobs that the job needs
  std::string settings_digest;
  std::string action_digest;
  std::string build_id;
  std::string traceparent;
  std::string webhook_url = {};  ///< URL to notify at the job's end (webhook_store.h); empty: none
  int64_t max_open = INT64_MAX;  ///< largest number of waiting and running jobs of the tenant
  /// Reason to refuse a new job. If `refusal` is an error, Create makes no new job and returns
  /// `refusal`. But if an earlier call with the same request_id has created a job, Create returns
  /// this job.
  absl::Status refusal = absl::OkStatus();
};

/// Job that Create returns.
struct Created {
  JobRecord job;
  bool fresh = true;  ///< false if an earlier call with the same request_id created the job

  friend bool operator==(const Created&, const Created&) = default;
};

/// Right to write to a job. The coordinator that claimed the job last has it. `epoch`: number of
/// the claim.
struct Lease {
  std::string job_id;
  int64_t epoch = 0;

  friend auto operator<=>(const Lease&, const Lease&) = default;
};

/// Job with a lease that was renewed.
struct HeldJob {
  Lease lease;
  bool cancel_requested = false;
  int64_t deadline_us = kNoDeadlineUs;

  friend bool operator==(const HeldJob&, const HeldJob&) = default;
};

/// Update of a job by the coordinator that has its lease.
struct JobUpdate {
  JobState state = JobState::kRunning;
  int32_t layers_total = 0;
  int32_t layers_done = 0;
  std::optional<JobError> error = {};
  std::optional<JobResult> result = {};
  /// With QUEUED: time before which the job cannot be claimed again.
  int64_t claimable_from_us = 0;
  bool retry = false;         ///< with QUEUED: true if the reason is a failed run
  bool store_failed = false;  ///< with QUEUED: true if the reason is a failed store
  bool deadly = false;        ///< with QUEUED: true if services probably died of the run
  /// New value of JobRecord::lost_runs. With RUNNING it already counts this run, which is lost if
  /// it never writes again (LostRuns::After).
  int32_t lost_runs = 0;
  std::string trace_sha256 = {};  ///< if empty, the stored value stays
};

/// Changes of a job by a client. Missing values stay unchanged.
struct JobChanging {
  std::optional<Priority> priority = {};
  std::optional<int64_t> deadline_us = {};
  std::optional<std::map<std::string, std::string>> labels = {};
};

/// Conditions and order of a list of jobs. A job must fulfil all conditions. The default of each
/// condition matches every job.
struct ListQuery {
  std::string tenant = {};
  bool all_tenants = false;  ///< true to list the jobs of all tenants; `tenant` is then ignored
  std::vector<JobState> states = {};
  std::map<std::string, std::string> labels = {};
  std::optional<Priority> priority = {};
  int64_t created_from_us = 0;
  int64_t created_before_us = INT64_MAX;
  bool oldest_first = false;
  /// JobRecord::number of the last job of the previous page: the list begins after this job. 0: the
  /// list begins with the first job.
  int64_t after_number = 0;
  int32_t limit = 50;
};

/// Position of an event in the order of all events.
struct EventCursor {
  int64_t time_us = 0;
  int64_t number = -1;  ///< JobRecord::number of the event's job
  int64_t sequence = -1;

  friend auto operator<=>(const EventCursor&, const EventCursor&) = default;
};

/// Event of a job of a tenant.
struct TenantEvent {
  std::string job_id;
  EventCursor cursor;
  JobEventRecord event;

  friend bool operator==(const TenantEvent&, const TenantEvent&) = default;
};

/// Total size of specs at which a list ends, even if it has fewer jobs than its limit. The list
/// includes the job with which it reaches this size.
inline constexpr int64_t kListedSpecBytes = 8 << 20;

/// Jobs that a claim may take.
struct ClaimFilter {
  Priority at_least = Priority::kBulk;
  bool of_idle_tenants = false;  ///< only jobs of tenants without a held job
};

/// Number of open jobs with one state and priority.
struct OpenJobs {
  JobState state = JobState::kQueued;
  Priority priority = Priority::kNormal;
  int64_t count = 0;
  int64_t oldest_us = 0;  ///< time at which the oldest of these jobs was created

  friend bool operator==(const OpenJobs&, const OpenJobs&) = default;
};

/// Number of the latest ended jobs from which the mean duration of a run is computed.
inline constexpr int32_t kLatestRuns = 50;

/// Longest storage time of a request_id. It is deleted together with its job.
inline constexpr int64_t kRequestIdKeptUs = int64_t{7} * 24 * 3600 * 1'000'000;

/// Store of jobs, their events, idempotency keys (request ids) and the index of results. All
/// changes that a call has acknowledged are on disk. The caller passes its clock as `now_us`.
/// Thread-safe; several coordinators may share one store.
///
/// A job is held while a coordinator has claimed it and the lease has not expired.
///
/// Errors of all functions: STORE_FAILED; DISK_FULL; JOB_NOT_FOUND if a job id is given; Aborted if
/// a lease is given and the job was claimed again or has ended. After Aborted, the caller must drop
/// the job.
class JobStore {
 public:
  virtual ~JobStore() = default;

  /// Creates a QUEUED job and its first event. If an earlier call with the same request_id has
  /// created a job, returns that job. Errors: REQUEST_ID_REUSED if the request_id was used for
  /// another spec; `job.refusal`; QUEUE_FULL if the tenant has `max_open` open jobs.
  virtual absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) = 0;

  /// Creates all jobs or none, in order. Jobs of earlier calls are returned as in Create. Errors:
  /// the first error, as in Create.
  virtual absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                         int64_t now_us) = 0;

  /// Returns a job.
  virtual absl::StatusOr<JobRecord> Get(const std::string& id) = 0;

  /// Returns the tenant of a job, even if the other fields of its record cannot be read.
  virtual absl::StatusOr<std::string> TenantOf(const std::string& id) = 0;

  /// Returns a page of a list of jobs.
  virtual absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) = 0;

  /// Gives an open job that no coordinator holds to `owner` until `until_us`. Returns nullopt if
  /// there is none. Skips jobs that `filter` excludes.
  ///
  /// Skips a job with the same action_digest as a held job, so that the same work is done only
  /// once. Exception: if one of the two jobs is to be cancelled, the other job does not have to
  /// wait for it.
  ///
  /// Tenants take turns; tenants with fewer held jobs come first. Of a tenant's jobs, higher
  /// priorities come first, then earlier deadlines, then older jobs. Errors: DATA_LOSS if the
  /// record of the job cannot be read; the job is skipped until `until_us`.
  virtual absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                         int64_t until_us,
                                                         const ClaimFilter& filter = {}) = 0;

  /// Ends at most `limit` overdue jobs as FAILED with `error`, in the order of their deadlines. A
  /// job is overdue if it is open, its deadline has passed, no coordinator holds it, and it is not
  /// to be cancelled. Returns the ended jobs without their specs, even if a later job could not be
  /// ended. If an error is returned, no job was ended.
  virtual absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                            int32_t limit) = 0;

  /// Writes the digests `identity` of a held job, as computed by the build that runs it. This build
  /// may differ from the build that created the job. Resets the counts of lost and deadly runs.
  /// Returns false if another held job that is not to be cancelled has the same work; the caller
  /// must then return this job to the queue.
  virtual absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                                     int64_t now_us) = 0;

  /// Extends these leases at least to `until_us`, and returns the jobs that are still held. Renews
  /// the given leases only, not all leases of an owner. So the lease of a job that its owner has
  /// given up expires, and the job is claimed again. Never shortens a lease, so a late renewal does
  /// no harm.
  virtual absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                                     int64_t until_us) = 0;

  /// Releases all jobs of `owner`. A coordinator calls this function at its start, for the jobs
  /// that it left when it last ended.
  virtual absl::Status Release(const std::string& owner) = 0;

  /// Writes state and progress, and appends an event. Releases a job that ends or is QUEUED again.
  /// If a client has requested the end of the job, the job becomes CANCELLED without a result
  /// instead of QUEUED or SUCCEEDED.
  ///
  /// A result that is not `cached` is added to the index of results. A `cached` result must still
  /// be in the index. The returned record has no spec. Errors: NotFound (BLOB_NOT_FOUND) if a
  /// cached result is not in the index any more; Internal if the job must not change to this state
  /// (MayFollow).
  virtual absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                           int64_t now_us) = 0;

  /// Requests the end of a job. A QUEUED job that no coordinator holds becomes CANCELLED at once; a
  /// held job is marked for its owner; an ended job does not change. The returned record has no
  /// spec.
  virtual absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) = 0;

  /// Changes the labels of a job; if the job is open, also its priority and deadline. The owner
  /// learns of the new deadline when it renews its lease. Appends an event. The returned record has
  /// no spec.
  virtual absl::StatusOr<JobRecord> Change(const std::string& id, const JobChanging& changing,
                                           int64_t now_us) = 0;

  /// Removes an ended job with its events and its request_id. A result leaves the index if no job
  /// refers to its blobs any more. Errors: JOB_NOT_FINISHED.
  virtual absl::Status Delete(const std::string& id) = 0;

  /// Returns the existing jobs that calls with these request ids created, in the same order.
  /// Errors: REQUEST_ID_REUSED if an id was used for another spec.
  virtual absl::StatusOr<std::vector<JobRecord>> FindRequested(
      const std::string& tenant, const std::vector<std::string>& request_ids,
      const std::string& spec_digest) = 0;

  /// Returns a job as Get does, without its spec, which may have a MiB.
  virtual absl::StatusOr<JobRecord> GetWithoutSpec(const std::string& id) = 0;

  /// Returns at most `limit` events with a sequence above `after`.
  virtual absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                             int32_t limit) = 0;

  /// Returns at most `limit` events of the tenant's jobs after the position `after`, in the order
  /// of TenantEvent::cursor. An event may appear in the store after events with later times,
  /// because its time is taken before it is written. Cost: reads all tenants' events from the time
  /// of `after` on.
  virtual absl::StatusOr<std::vector<TenantEvent>> EventsOf(const std::string& tenant,
                                                            const EventCursor& after,
                                                            int32_t limit) = 0;

  /// Returns the stored result with this action_digest; nullopt if there is none.
  virtual absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) = 0;
  /// Removes the stored result with this action_digest from the index.
  virtual absl::Status ForgetResult(const std::string& action_digest) = 0;

  /// Removes request ids that are older than kRequestIdKeptUs.
  virtual absl::Status ExpireRequestIds(int64_t now_us) = 0;

  /// Returns the number of ended jobs by state. Cost: reads the index of states.
  virtual absl::StatusOr<std::map<JobState, int64_t>> CountEnded() = 0;

  /// Returns the number of the tenant's jobs, including ended ones. Cost: reads the index of its
  /// jobs.
  virtual absl::StatusOr<int64_t> CountOf(const std::string& tenant) = 0;

  /// Returns the number of the tenant's open jobs by state.
  virtual absl::StatusOr<std::map<JobState, int64_t>> CountOpenOf(const std::string& tenant) = 0;

  /// Returns the number of open jobs by state and priority. Combinations without jobs are left out.
  virtual absl::StatusOr<std::vector<OpenJobs>> CountOpen() = 0;

  /// Returns the open jobs in the order in which Claim gives them. Includes jobs that cannot be
  /// claimed yet, because a run failed a moment ago or because a held job has the same work. Cost:
  /// reads the index of open jobs, and the last kLatestRuns ended jobs.
  virtual absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) = 0;

  /// Returns the subset of `digests` that are inputs, results or traces of jobs of the tenant.
  /// Cost: one statement.
  virtual absl::StatusOr<std::set<std::string>> Referenced(
      const std::string& tenant, const std::set<std::string>& digests) = 0;

  /// Returns the subset of `digests` that are results or traces of jobs. `digests`: names of blobs
  /// of the tenant.
  virtual absl::StatusOr<std::set<std::string>> Artifacts(const std::string& tenant,
                                                          const std::set<std::string>& digests) = 0;

  /// Returns at most `limit` jobs that ended before `time_us`, the oldest first. Skips jobs with a
  /// webhook that is still to be sent (webhook_store.h).
  virtual absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) = 0;

  /// Takes the right to do the chore until `until_us`; only one coordinator at a time has it.
  /// Returns false if another coordinator has it. `chore`: name of a regular task, such as the
  /// sweep.
  virtual absl::StatusOr<bool> TakeChore(const std::string& chore, int64_t now_us,
                                         int64_t until_us) = 0;

  /// Records that the store is in use at `now_us`. Returns the time since which the store has been
  /// in use without an interruption of more than `most_gap_us`. Returns `now_us` for a new store
  /// and for a store that was restored from a backup.
  virtual absl::StatusOr<int64_t> InUseSince(int64_t now_us, int64_t most_gap_us) = 0;
};

}  // namespace slicefarm::coordinator
