#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Arguments of JobStore::Claim. The functions of this file implement Claim in SQL.
struct ClaimRequest {
  std::string owner;
  int64_t now_us = 0;
  int64_t until_us = 0;
  ClaimFilter filter;
};

/// Job that may be claimed.
struct Candidate {
  int64_t number = 0;
  std::string action_digest;
};

/// Next job to claim, and the tenants with claimable jobs.
struct Queue {
  Candidate first;
  /// Tenants in the order of their turns, beginning with the tenant of `first`.
  std::vector<std::string> tenants;
};

/// Returns the queue; nullopt if no job may be claimed. Cost: one search in an index per tenant.
absl::StatusOr<std::optional<Queue>> FindQueue(SqlConnection& db, const ClaimRequest& request);

/// Job that was claimed.
struct Claimed {
  JobRecord job;
  absl::Status read;  ///< DATA_LOSS if the row is damaged; `job` then has the readable fields
};

/// Result of one try to claim a job. If `claimed` is empty and `nothing_left` is false, another
/// coordinator was faster, and there may be more jobs.
struct ClaimTry {
  std::optional<Claimed> claimed = {};
  bool nothing_left = false;
};

/// Claims the first job of the queue. Runs in its own transaction, because transactions that lock
/// the work of several jobs could deadlock with each other.
absl::StatusOr<ClaimTry> TakeFirst(SqlConnection& db, const Queue& queue,
                                   const ClaimRequest& request);
/// Claims the first job that the tenants of the queue have now. To be called if another coordinator
/// has taken the first job of the queue. Skips jobs that another transaction is writing. Runs in
/// its own transaction, like TakeFirst.
absl::StatusOr<ClaimTry> TakeNext(SqlConnection& db, const Queue& queue,
                                  const ClaimRequest& request);

/// Returns true if another held job than `but_job` has this digest and is not to be cancelled.
/// REQUIRES: a transaction; until its end, no other claim takes a job with this digest.
absl::StatusOr<bool> OthersHold(SqlConnection& db, const std::string& action_digest,
                                const std::string& but_job, int64_t now_us);

/// Implements JobStore::Renew in SQL.
absl::StatusOr<std::vector<HeldJob>> RenewLeases(SqlConnection& db,
                                                 const std::vector<Lease>& leases,
                                                 int64_t until_us);

/// Returns the SQL for the tenants in the order of their turns; public for a test of its query
/// plan.
std::string TenantsSql(const SqlDialect& dialect);
/// Returns the SQL for the next job of a tenant; public for a test of its query plan.
std::string ClaimableSql(const SqlDialect& dialect);

}  // namespace slicefarm::coordinator
