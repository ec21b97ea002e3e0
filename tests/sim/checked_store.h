#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "tests/sim/claim_order.h"
#include "tests/sim/world.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::sim {

/// The store as the coordinators see it, with an eye on every call: what it answers, what it did to
/// the record it is about, and what it did to all others. Tells the world of promises that are
/// broken.
class CheckedStore : public ForwardingJobStore {
 public:
  /// `store` keeps its jobs in `jobs`.
  CheckedStore(World& world, JobStore& store, const MemoryJobs& jobs);

  /// A client has been told that this job was made for it.
  void Acknowledged(const std::string& job_id);
  bool Deleted(const std::string& job_id) const { return deleted_.contains(job_id); }
  /// nullptr: there is no such job.
  const JobRecord* Find(const std::string& job_id) const;
  /// The first job that has not ended; empty: all have.
  std::string Unended() const;
  void CountEnds();

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override;
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter) override;
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
  absl::Status Delete(const std::string& id) override;

 private:
  /// What was seen of a job so far.
  struct Seen {
    JobRecord job;
    size_t events = 0;
    int64_t cancel_epoch = -1;  ///< of the claim under which its end was requested; -1: it was not
    int64_t claimed_us = 0;     ///< on the clock of who claimed it last
  };
  struct Requested {
    std::string job_id;
    std::string spec_digest;
  };

  void CheckCreated(const NewJob& job, const Requested* earlier, bool full,
                    const absl::StatusOr<Created>& created);
  void CheckFresh(const NewJob& job, const JobRecord& record);
  void CheckClaim(const JobRecord& job, const std::string& owner, int64_t now_us);
  bool IsFull(const NewJob& job) const;
  void Wrote(const JobRecord& job);
  void CheckAll();
  void CheckJob(const MemoryJobs::Entry& entry, Seen& seen);
  void CheckBlobs(const MemoryJobs::Entry& entry);
  void CheckEvents(const MemoryJobs::Entry& entry, Seen& seen);
  void CheckEnd(const JobRecord& job, const Seen& seen);
  void CheckFailure(const JobRecord& job, const Seen& seen);

  World& world_;
  const MemoryJobs& jobs_;
  ClaimOrder claim_order_;
  std::map<int64_t, Work> works_;                                      ///< by id
  std::map<std::string, Seen> seen_;                                   ///< by job
  std::map<std::pair<std::string, std::string>, Requested> requests_;  ///< by tenant, request id
  std::set<std::string> acknowledged_;
  std::set<std::string> deleted_;
};

}  // namespace slicefarm::coordinator::sim
