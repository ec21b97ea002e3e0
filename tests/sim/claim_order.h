#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::sim {

/// Checks that claims keep the order that JobStore::Claim promises, and that no tenant is passed
/// over for long.
class ClaimOrder {
 public:
  /// Arguments of a claim.
  struct Call {
    int64_t now_us = 0;
    ClaimFilter filter = {};
  };

  /// Records the state before the claim.
  void Before(const std::map<int64_t, MemoryJobs::Entry>& jobs, const Call& call);

  /// Checks the result of the claim. Returns a description of the broken promise; nullopt if there
  /// is none. `claimed`: the claimed job, or null.
  std::optional<std::string> After(const Call& call, const JobRecord* claimed);

 private:
  /// Tenant with open jobs at the time of the claim.
  struct Tenant {
    int64_t held = 0;
    /// next claimable job of this tenant; empty if no job may be claimed
    std::optional<JobRecord> next;
  };

  std::optional<std::string> CheckPassedOver(const Call& call, const std::string& taken);
  /// Returns the tenant that must get the next claim; nullptr if no job may be claimed.
  const Tenant* First() const;

  std::map<std::string, Tenant> tenants_;
  std::map<std::string, int64_t> turns_us_;  ///< time of the last claim of a job of the tenant
  /// Number of claims for other tenants since this tenant's last claim, while this tenant held no
  /// job and had a claimable job.
  std::map<std::string, size_t> passed_over_;
  int64_t latest_us_ = 0;
};

}  // namespace slicefarm::coordinator::sim
