#pragma once

#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/forwarding_job_store.h"

namespace slicefarm::coordinator {

/// Job store that counts the writes of this coordinator:
///   slicefarm_jobs_submitted_total              new jobs;
///   slicefarm_jobs_total{state,reason}          ended jobs;
///   slicefarm_job_seconds{phase}                times of ended jobs: queue, run, total;
///   slicefarm_jobs_requeued_total{cause}        runs that ended with the job back in the queue;
///   slicefarm_cache_hits_total                  jobs that ended with a cached result;
///   slicefarm_cache_misses_total                runs that had to compute;
///   slicefarm_lease_expired_total               claims of jobs that a coordinator left running;
///   slicefarm_fenced_writes_total               refused writes, because the job was claimed again;
///   slicefarm_store_commit_seconds{operation}   time of calls that write.
class MeteredJobStore : public ForwardingJobStore {
 public:
  /// Wraps `store`. `store` and `registry` must outlive this object.
  MeteredJobStore(JobStore& store, prometheus::Registry& registry);

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override;
  absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                 int64_t now_us) override;
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter = {}) override;
  absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                    int32_t limit) override;
  absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                             int64_t now_us) override;
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override;
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override;
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override;
  absl::Status Delete(const std::string& id) override;

 private:
  template <typename Call>
  auto Timed(const std::string& operation, const Call& call);
  void Ended(const JobRecord& job);
  void Requeued(const JobUpdate& update);

  prometheus::Counter& submitted_;
  prometheus::Family<prometheus::Counter>& ended_;
  prometheus::Family<prometheus::Histogram>& job_seconds_;
  prometheus::Family<prometheus::Counter>& requeued_;
  prometheus::Counter& hits_;
  prometheus::Counter& misses_;
  prometheus::Counter& expired_;
  prometheus::Counter& fenced_;
  prometheus::Family<prometheus::Histogram>& commit_seconds_;
};

}  // namespace slicefarm::coordinator
