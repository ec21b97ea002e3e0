#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::sim {

/// Watches that claims keep the order that JobStore::Claim promises, and that no tenant is passed
/// over for long.
class ClaimOrder {
 public:
  struct Call {
    int64_t now_us = 0;
    ClaimFilter filter = {};
  };

  /// Before the claim is made.
  void Before(const std::map<int64_t, MemoryJobs::Entry>& jobs, const Call& call);

  /// `claimed`: what it came to. What was promised otherwise; none: nothing.
  std::optional<std::string> After(const Call& call, const JobRecord* claimed);

 private:
  /// A tenant with open jobs, as the claim finds it.
  struct Tenant {
    int64_t held = 0;
    std::optional<JobRecord> next;  ///< whose turn it is among its jobs; none: none may be claimed
  };

  std::optional<std::string> CheckPassedOver(const Call& call, const std::string& taken);
  /// The tenant whose turn it is; nullptr: nothing may be claimed.
  const Tenant* First() const;

  std::map<std::string, Tenant> tenants_;
  std::map<std::string, int64_t> turns_us_;  ///< when a job of the tenant was claimed last
  /// How often others were served while it held nothing and had something to do.
  std::map<std::string, size_t> passed_over_;
  int64_t latest_us_ = 0;
};

}  // namespace slicefarm::coordinator::sim
