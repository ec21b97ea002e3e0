#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Content of a MemoryJobStore. Several stores may share one object of this class, like a database.
class MemoryJobs {
 public:
  struct Entry {
    JobRecord job;
    std::vector<std::string> inputs;
    std::vector<JobEventRecord> events;
  };

  /// Returns the jobs by number, without a lock. Only for use while no call of a store runs.
  const std::map<int64_t, Entry>& entries() const { return entries_; }
  /// Returns the job, or nullptr.
  const Entry* Find(const std::string& id) const;

 private:
  friend class MemoryJobStore;

  struct Request {
    std::string job_id;
    std::string spec_digest;
    int64_t create_us = 0;
  };

  std::mutex mutex_;
  int64_t last_number_ = 0;
  std::map<int64_t, Entry> entries_;
  std::unordered_map<std::string, int64_t> numbers_;  ///< number of each job, by id
  /// Requests by tenant and request id.
  std::map<std::pair<std::string, std::string>, Request> requests_;
  std::map<std::string, int64_t> turns_;      ///< time when a job of the tenant was last claimed
  std::map<std::string, JobResult> results_;  ///< results by action digest
  std::map<std::string, int64_t> chores_;     ///< end time of each chore's lease
};

/// JobStore without persistence, for the simulation and for tests. It fulfils the contract that
/// job_store_contract_test.cc tests, by the rules in job_steps.h, which the stores on disk use as
/// well. Calls fail only because of errors of the caller.
class MemoryJobStore : public JobStore {
 public:
  /// Creates a store with the content `jobs`, which must outlive it.
  explicit MemoryJobStore(MemoryJobs& jobs) : jobs_(jobs) {}

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override;
  absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                 int64_t now_us) override;
  absl::StatusOr<JobRecord> Get(const std::string& id) override;
  absl::StatusOr<std::string> TenantOf(const std::string& id) override;
  absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) override;
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter = {}) override;
  absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                    int32_t limit) override;
  absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                             int64_t now_us) override;
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override;
  absl::Status Release(const std::string& owner) override;
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override;
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override;
  absl::StatusOr<JobRecord> Change(const std::string& id, const JobChanging& changing,
                                   int64_t now_us) override;
  absl::Status Delete(const std::string& id) override;
  absl::StatusOr<std::vector<JobRecord>> FindRequested(const std::string& tenant,
                                                       const std::vector<std::string>& request_ids,
                                                       const std::string& spec_digest) override;
  absl::StatusOr<JobRecord> GetWithoutSpec(const std::string& id) override;
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override;
  absl::StatusOr<std::vector<TenantEvent>> EventsOf(const std::string& tenant,
                                                    const EventCursor& after,
                                                    int32_t limit) override;
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) override;
  absl::Status ForgetResult(const std::string& action_digest) override;
  absl::Status ExpireRequestIds(int64_t now_us) override;
  absl::StatusOr<std::map<JobState, int64_t>> CountEnded() override;
  absl::StatusOr<int64_t> CountOf(const std::string& tenant) override;
  absl::StatusOr<std::map<JobState, int64_t>> CountOpenOf(const std::string& tenant) override;
  absl::StatusOr<std::vector<OpenJobs>> CountOpen() override;
  absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) override;
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override;
  absl::StatusOr<std::set<std::string>> Artifacts(const std::string& tenant,
                                                  const std::set<std::string>& digests) override;
  absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) override;
  absl::StatusOr<int64_t> InUseSince(int64_t now_us, int64_t most_gap_us) override;
  absl::StatusOr<bool> TakeChore(const std::string& chore, int64_t now_us,
                                 int64_t until_us) override;

 private:
  using Entry = MemoryJobs::Entry;

  Entry* Find(const std::string& id);
  Entry* FindHeld(const Lease& lease);
  absl::Status CheckQueue(const NewJob& job, int64_t before) const;
  absl::StatusOr<std::optional<Created>> FindEarlier(const NewJob& job);
  Created Insert(const NewJob& job, int64_t now_us);
  std::vector<std::string> Tenants(int64_t now_us, const ClaimFilter& filter) const;
  std::set<std::string> HeldWork(int64_t now_us, const std::string& but_job = "") const;
  JobRecord* Claimable(const std::string& tenant, int64_t now_us, const ClaimFilter& filter);
  absl::Status IndexResult(const JobRecord& job);
  bool IsArtifact(const std::string& tenant, const std::string& digest) const;
  bool IsInput(const std::string& tenant, const std::string& digest) const;
  void ForgetUnreferenced(const std::string& tenant, const std::string& digest);

  MemoryJobs& jobs_;
};

}  // namespace slicefarm::coordinator
