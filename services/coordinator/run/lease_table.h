#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "services/coordinator/run/run_requests.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Leases of one coordinator. Decides the effect of the store's answers, or of missing answers, on
/// the runs. A pure state machine; its outputs are the RunRequests of the runs. Times are
/// microseconds on the coordinator's clock. Not thread-safe.
class LeaseTable {
 public:
  explicit LeaseTable(int64_t lease_us) : lease_us_(lease_us) {}

  /// Returns the end of a lease that is claimed or renewed at `now_us`.
  int64_t UntilUs(int64_t now_us) const { return now_us + lease_us_; }

  /// Adds a run with its lease. `claimed_us`: a time before the claim was sent to the store.
  void Add(const Lease& lease, int64_t claimed_us, std::shared_ptr<RunRequests> wishes);

  /// Removes the lease of a run that has ended.
  void Remove(const Lease& lease) { held_.erase(lease); }

  /// Returns the leases of all runs that have not lost their job. A lost run writes nothing more,
  /// and its lease must expire, so that the job can be claimed again.
  std::vector<Lease> ToRenew() const;

  /// Applies the store's answer to a renewal. `asked`: leases that were to be renewed until
  /// `until_us`; `held`: leases that the store has renewed. A run loses its job if its lease is not
  /// in `held`. A run is cancelled if a client has requested the end of its job.
  void Renewed(const std::vector<Lease>& asked, const std::vector<HeldJob>& held, int64_t until_us);

  /// Ends all runs with less than a fifth of their lease left, because the store has not answered
  /// for long. Two coordinators must not work on the same job, so the runs stop early.
  void GiveUpLate(int64_t now_us);

  /// Cancels the run of the job, if there is one.
  void Cancel(const std::string& job_id);
  /// Returns the jobs of all runs to the queue, because the coordinator stops.
  void HandBackAll();

 private:
  struct Held {
    std::shared_ptr<RunRequests> wishes;  // shared with the run
    int64_t until_us = 0;                 ///< end of the lease in the store
  };

  int64_t lease_us_;
  /// Runs by lease. A job has two leases in the table if it was given up and claimed again before
  /// its first run ended.
  std::map<Lease, Held> held_;
};

}  // namespace slicefarm::coordinator
