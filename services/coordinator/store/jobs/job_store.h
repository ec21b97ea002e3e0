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

struct NewJob {
  std::string id;
  std::string tenant;
  std::string request_id;   ///< of the tenant's; empty: the call is not idempotent
  std::string spec_digest;  ///< equal for equal requests
  std::string spec;
  std::map<std::string, std::string> labels;
  Priority priority = Priority::kNormal;
  int64_t deadline_us = kNoDeadlineUs;
  std::vector<std::string> inputs;  ///< digests of the blobs that it needs
  std::string settings_digest;
  std::string action_digest;
  std::string build_id;
  std::string traceparent;
  std::string webhook_url = {};  ///< to be told of its end (webhook_store.h); empty: none
  int64_t max_open = INT64_MAX;  ///< jobs that the tenant may have waiting or running
  /// Why no job is made; but one that an earlier call with the same request_id made is found.
  absl::Status refusal = absl::OkStatus();
};

struct Created {
  JobRecord job;
  bool fresh = true;  ///< false: an earlier call with the same request_id made it

  friend bool operator==(const Created&, const Created&) = default;
};

/// The right to write to a job: of the coordinator that claimed it last.
struct Lease {
  std::string job_id;
  int64_t epoch = 0;

  friend auto operator<=>(const Lease&, const Lease&) = default;
};

struct HeldJob {
  Lease lease;
  bool cancel_requested = false;
  int64_t deadline_us = kNoDeadlineUs;

  friend bool operator==(const HeldJob&, const HeldJob&) = default;
};

/// What the owner writes.
struct JobUpdate {
  JobState state = JobState::kRunning;
  int32_t layers_total = 0;
  int32_t layers_done = 0;
  std::optional<JobError> error = {};
  std::optional<JobResult> result = {};
  /// With QUEUED: nobody claims it before.
  int64_t claimable_from_us = 0;
  bool retry = false;             ///< with QUEUED: because a run failed
  bool store_failed = false;      ///< with QUEUED: because a store failed
  bool deadly = false;            ///< with QUEUED: because services died of the run, as it seems
  int32_t lost_runs = 0;          ///< of the record, if this is the last that is heard of the run
  std::string trace_sha256 = {};  ///< empty: what was there stays
};

/// What a client changes of a job; what is not there stays.
struct JobChanging {
  std::optional<Priority> priority = {};
  std::optional<int64_t> deadline_us = {};
  std::optional<std::map<std::string, std::string>> labels = {};
};

/// Which jobs, in what order. All conditions hold at once; those at their standard hold for all.
struct ListQuery {
  std::string tenant = {};
  bool all_tenants = false;  ///< whatever `tenant` says
  std::vector<JobState> states = {};
  std::map<std::string, std::string> labels = {};
  std::optional<Priority> priority = {};
  int64_t created_from_us = 0;
  int64_t created_before_us = INT64_MAX;
  bool oldest_first = false;
  int64_t after_number = 0;  ///< what comes after this job in that order; 0: from the beginning
  int32_t limit = 50;
};

/// Where an event stands among those of all jobs.
struct EventPlace {
  int64_t time_us = 0;
  int64_t number = -1;  ///< of the job
  int64_t sequence = -1;

  friend auto operator<=>(const EventPlace&, const EventPlace&) = default;
};

struct TenantEvent {
  std::string job_id;
  EventPlace place;
  JobEventRecord event;

  friend bool operator==(const TenantEvent&, const TenantEvent&) = default;
};

/// A list ends with the job whose spec brings it to so many bytes of specs, whatever its limit.
inline constexpr int64_t kListedSpecBytes = 8 << 20;

/// Which jobs a claim may take.
struct ClaimFilter {
  Priority at_least = Priority::kBulk;
  bool of_idle_tenants = false;  ///< only of tenants none of whose jobs somebody holds
};

/// Jobs of one kind that have not ended.
struct OpenJobs {
  JobState state = JobState::kQueued;
  Priority priority = Priority::kNormal;
  int64_t count = 0;
  int64_t oldest_us = 0;  ///< when the one that has waited longest was created

  friend bool operator==(const OpenJobs&, const OpenJobs&) = default;
};

/// How many ended jobs tell how long a run takes.
inline constexpr int32_t kLatestRuns = 50;

/// How long a request_id is remembered, at most: it goes with its job.
inline constexpr int64_t kRequestIdKeptUs = int64_t{7} * 24 * 3600 * 1'000'000;

/// Jobs, their events, idempotency keys and the index of results. Whatever a call acknowledged is
/// on disk. The clock is the caller's: `now_us`. Thread-safe; several coordinators may share one
/// store.
///
/// Errors of all: STORE_FAILED; DISK_FULL; JOB_NOT_FOUND where a job is named; Aborted where a
/// lease is, if the job was claimed by another since, or has ended: "you were fenced, drop it".
class JobStore {
 public:
  virtual ~JobStore() = default;

  /// Makes a QUEUED job and its first event. Errors: REQUEST_ID_REUSED if the request_id made
  /// another job's spec; `job.refusal`; QUEUE_FULL if the tenant has `max_open` jobs that have not
  /// ended.
  virtual absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) = 0;

  /// Makes all jobs or none, in order; those that earlier calls made are as Create has them.
  /// Errors: the first one of Create's.
  virtual absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                         int64_t now_us) = 0;

  virtual absl::StatusOr<JobRecord> Get(const std::string& id) = 0;

  /// Whose job it is, also if the rest of what is kept of it cannot be read.
  virtual absl::StatusOr<std::string> TenantOf(const std::string& id) = 0;

  virtual absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) = 0;

  /// Gives a job that is QUEUED or RUNNING and that nobody holds to `owner` until `until_us`; none
  /// if there is none. Passes over jobs whose action_digest is that of a job that somebody holds
  /// and that is not to be cancelled, so that the same work is done once (but not over those that
  /// are to be cancelled themselves: they end at once), and those that `filter` leaves out. Tenants
  /// take turns, those with fewer held jobs first; of a tenant's jobs those of higher priority come
  /// first, then those with the earlier deadline, then the older ones. Errors: DATA_LOSS if what is
  /// kept of the job cannot be read; it is passed over until `until_us`.
  virtual absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                         int64_t until_us,
                                                         const ClaimFilter& filter = {}) = 0;

  /// Ends jobs that have not ended, that nobody holds or wants to be cancelled, and whose deadline
  /// has passed, as FAILED with `error`; at most `limit`, in the order of their deadlines. Returns
  /// those that it ended, without their specs, also if it could not go on; an error says that it
  /// ended none.
  virtual absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                            int32_t limit) = 0;

  /// Writes what a held job is to the build that works on it, which may be another one than made
  /// it, and has lost no run of it. False: somebody holds another job of the same work that is not
  /// to be cancelled, so this one is to be put back.
  virtual absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                                     int64_t now_us) = 0;

  /// Holds these claims at least until `until_us`, and tells which of them were still held. By
  /// claim and not by owner, so that a job which its owner has given up runs out and is claimed
  /// again. Never shortens a claim, so that a renewal that arrives after a later one does no harm.
  virtual absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                                     int64_t until_us) = 0;

  /// Lets go of all jobs of `owner`: those of an earlier life, at the start.
  virtual absl::Status Release(const std::string& owner) = 0;

  /// Writes state and progress and appends an event. A state that may not follow is Internal. An
  /// ended job and one that is QUEUED again are let go; one whose end was requested becomes neither
  /// QUEUED nor SUCCEEDED but CANCELLED, without a result. A result that is not `cached` enters the
  /// index; one that is must still be in it (NotFound, reason BLOB_NOT_FOUND, otherwise). The
  /// record comes without its spec.
  virtual absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                           int64_t now_us) = 0;

  /// A QUEUED job that nobody holds ends as CANCELLED at once; a held one is marked for its owner;
  /// to an ended one nothing happens. The record comes without its spec.
  virtual absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) = 0;

  /// Changes labels, and of a job that has not ended priority and deadline, of which its owner
  /// hears when it renews its claim. Appends an event. The record comes without its spec.
  virtual absl::StatusOr<JobRecord> Change(const std::string& id, const JobChanging& changing,
                                           int64_t now_us) = 0;

  /// Removes an ended job with its events and its request_id. Results of whose blobs no job is left
  /// leave the index. Errors: JOB_NOT_FINISHED.
  virtual absl::Status Delete(const std::string& id) = 0;

  /// The jobs that calls with these request ids made and that are still there, in that order.
  /// Errors: REQUEST_ID_REUSED if one was for another spec.
  virtual absl::StatusOr<std::vector<JobRecord>> FindRequested(
      const std::string& tenant, const std::vector<std::string>& request_ids,
      const std::string& spec_digest) = 0;

  /// Get, but its spec is left out, which may be a MiB.
  virtual absl::StatusOr<JobRecord> GetWithoutSpec(const std::string& id) = 0;

  /// Events with a sequence above `after`, at most `limit`.
  virtual absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                             int32_t limit) = 0;

  /// Events of the tenant's jobs, in the order of TenantEvent::place, that come after `after`; at
  /// most `limit`. One may be there later than others of a later time: times are those of the
  /// callers' clocks, and from before it was written. Cost: reads the events of all tenants from
  /// that time on.
  virtual absl::StatusOr<std::vector<TenantEvent>> EventsOf(const std::string& tenant,
                                                            const EventPlace& after,
                                                            int32_t limit) = 0;

  /// What the same work came to before.
  virtual absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) = 0;
  virtual absl::Status ForgetResult(const std::string& action_digest) = 0;

  /// Forgets request ids that are older than kRequestIdKeptUs.
  virtual absl::Status ExpireRequestIds(int64_t now_us) = 0;

  /// Of those that have ended. Cost: reads the index of states.
  virtual absl::StatusOr<std::map<JobState, int64_t>> CountEnded() = 0;

  /// Jobs of the tenant, ended ones among them. Cost: reads the index of its jobs.
  virtual absl::StatusOr<int64_t> CountOf(const std::string& tenant) = 0;

  /// Those of the tenant that have not ended.
  virtual absl::StatusOr<std::map<JobState, int64_t>> CountOpenOf(const std::string& tenant) = 0;

  /// Those that have not ended, by state and priority; kinds of which there are none are left out.
  virtual absl::StatusOr<std::vector<OpenJobs>> CountOpen() = 0;

  /// Returns the open jobs in the order in which Claim gives them. Of a tenant's waiting jobs those
  /// are told too that cannot be claimed yet: because a run failed a moment ago, or the same work
  /// is held. Cost: reads the index of open jobs, and the last kLatestRuns that ended.
  virtual absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) = 0;

  /// Of these digests, those of inputs, results and traces of jobs among the tenant's blobs.
  /// Cost: a statement.
  virtual absl::StatusOr<std::set<std::string>> Referenced(
      const std::string& tenant, const std::set<std::string>& digests) = 0;

  /// Of these, those of results and traces alone.
  virtual absl::StatusOr<std::set<std::string>> Artifacts(const std::string& tenant,
                                                          const std::set<std::string>& digests) = 0;

  /// Jobs that ended before and whose receiver was told, if they have one (webhook_store.h); the
  /// oldest first, at most `limit`.
  virtual absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) = 0;

  /// The right to do what one coordinator at a time does for all, until `until_us`; false: another
  /// one has it.
  virtual absl::StatusOr<bool> TakeChore(const std::string& chore, int64_t now_us,
                                         int64_t until_us) = 0;

  /// Notes that the store is in use at `now_us`. Returns since when it has been in use without a
  /// break of more than `most_gap_us`; `now_us` for a new store, and for one restored from a
  /// backup.
  virtual absl::StatusOr<int64_t> InUseSince(int64_t now_us, int64_t most_gap_us) = 0;
};

}  // namespace slicefarm::coordinator
