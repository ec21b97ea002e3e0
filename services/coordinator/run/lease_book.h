#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "services/coordinator/run/run_wishes.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// The claims that one coordinator works on, and what becomes of them when the store answers or
/// does not: a pure state machine, whose outputs are the wishes of the runs. Times are microseconds
/// on the coordinator's clock. Not thread-safe.
class LeaseBook {
 public:
  explicit LeaseBook(int64_t lease_us) : lease_us_(lease_us) {}

  /// Until when a claim lasts that is made or renewed now.
  int64_t UntilUs(int64_t now_us) const { return now_us + lease_us_; }

  /// A run begins, under a claim that was made when the clock said `claimed_us`.
  void Add(const Lease& lease, int64_t claimed_us, std::shared_ptr<RunWishes> wishes);

  /// The run has ended.
  void Remove(const Lease& lease) { held_.erase(lease); }

  /// The leases of the runs that go on. One that was given up writes nothing any more, so its job
  /// has to run out, to be claimed again.
  std::vector<Lease> ToRenew() const;

  /// The store's answer to the renewal of `asked` until `until_us`. A run whose lease is not `held`
  /// any more is lost; one whose end was requested is cancelled.
  void Renewed(const std::vector<Lease>& asked, const std::vector<HeldJob>& held, int64_t until_us);

  /// Runs with less than a fifth of their lease left are lost: the store has not answered for long.
  /// Rather stop too early than work beside another coordinator.
  void GiveUpLate(int64_t now_us);

  void Cancel(const std::string& job_id);
  void HandBackAll();

 private:
  struct Held {
    std::shared_ptr<RunWishes> wishes;  // shared with the run
    int64_t until_us = 0;               ///< as the store has it
  };

  int64_t lease_us_;
  std::map<Lease, Held> held_;  ///< a job that was given up may be claimed again while it ends
};

}  // namespace slicefarm::coordinator
