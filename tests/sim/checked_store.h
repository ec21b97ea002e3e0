#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "tests/sim/claim_order.h"
#include "tests/sim/world.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::sim {

/// Job store of the simulated coordinators that checks every call: the answer, the effect on the
/// record of the call, and the effect on all other records. Reports broken promises to the world.
class CheckedStore : public ForwardingJobStore {
 public:
  /// Wraps `store`, which keeps its jobs in `jobs`.
  CheckedStore(World& world, JobStore& store, const MemoryJobs& jobs);

  /// Records that a client was notified about the creation of this job.
  void Acknowledged(const std::string& job_id);
  /// Returns true if the job was deleted.
  bool Deleted(const std::string& job_id) const { return deleted_.contains(job_id); }
  /// Returns the record of a job; nullptr if there is no such job.
  const JobRecord* Find(const std::string& job_id) const;
  /// Returns the id of the first open job; empty if all jobs have ended.
  std::string Unended() const;
  /// Adds the ended jobs to the totals.
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
  /// History of a job as this object has observed it.
  struct Seen {
    JobRecord job;
    size_t events = 0;
    /// Epoch of the claim during which the client requested the end of the job; -1: no request.
    int64_t cancel_epoch = -1;
    int64_t claimed_us = 0;  ///< time of the last claim, on the claimer's clock
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
  std::map<int64_t, Work> works_;     ///< works by id
  std::map<std::string, Seen> seen_;  ///< histories by job
  /// Requests by tenant and request id.
  std::map<std::pair<std::string, std::string>, Requested> requests_;
  std::set<std::string> acknowledged_;
  std::set<std::string> deleted_;
};

}  // namespace slicefarm::coordinator::sim
