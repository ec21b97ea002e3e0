#include "services/coordinator/run/lease_table.h"

#include <utility>

namespace slicefarm::coordinator {

void LeaseTable::Add(const Lease& lease, int64_t claimed_us, std::shared_ptr<RunRequests> wishes) {
  held_[lease] = {std::move(wishes), UntilUs(claimed_us)};
}

std::vector<Lease> LeaseTable::ToRenew() const {
  std::vector<Lease> leases;
  for (const auto& [lease, held] : held_) {
    if (!held.wishes->lost()) leases.push_back(lease);
  }
  return leases;
}

void LeaseTable::Renewed(const std::vector<Lease>& asked, const std::vector<HeldJob>& held,
                         int64_t until_us) {
  std::map<Lease, const HeldJob*> by_lease;
  for (const HeldJob& job : held) by_lease[job.lease] = &job;
  for (const Lease& lease : asked) {
    const auto found = held_.find(lease);
    if (found == held_.end()) continue;  // the run has ended meanwhile
    const auto still = by_lease.find(lease);
    if (still == by_lease.end()) {
      // The job was claimed by another coordinator. If instead the run has written its end, the
      // loss has no effect.
      found->second.wishes->Lose();
      continue;
    }
    found->second.until_us = until_us;
    found->second.wishes->EndBy(still->second->deadline_us);
    if (still->second->cancel_requested) found->second.wishes->Cancel();
  }
}

void LeaseTable::GiveUpLate(int64_t now_us) {
  for (const auto& [lease, held] : held_) {
    if (now_us > held.until_us - lease_us_ / 5) held.wishes->Lose();
  }
}

void LeaseTable::Cancel(const std::string& job_id) {
  for (const auto& [lease, held] : held_) {
    if (lease.job_id == job_id) held.wishes->Cancel();
  }
}

void LeaseTable::HandBackAll() {
  for (const auto& [lease, held] : held_) held.wishes->HandBack();
}

}  // namespace slicefarm::coordinator
