#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// JobStore::Claim in SQL.
struct ClaimRequest {
  std::string owner;
  int64_t now_us = 0;
  int64_t until_us = 0;
  ClaimFilter filter;
};

/// A job that may be claimed.
struct Candidate {
  int64_t number = 0;
  std::string action_digest;
};

/// Whose turn it is.
struct Queue {
  Candidate first;
  std::vector<std::string> tenants;  ///< in the order of their turns, from the one of `first` on
};

/// None: nothing may be claimed. Cost: one look into an index a tenant.
absl::StatusOr<std::optional<Queue>> FindQueue(SqlConnection& db, const ClaimRequest& request);

/// A job that was claimed.
struct Claimed {
  JobRecord job;
  absl::Status read;  ///< DATA_LOSS if it is damaged; `job` has what could be read
};

/// What a try came to: neither, if others were faster and there may be more.
struct ClaimTry {
  std::optional<Claimed> claimed = {};
  bool nothing_left = false;
};

/// Claims the first job of a queue that was found; or else, in a further try, what its tenants have
/// now, without those that somebody else is writing to. In a transaction of its own, each time: one
/// that took locks of several works would wait for others who wait for it.
absl::StatusOr<ClaimTry> TakeFirst(SqlConnection& db, const Queue& queue,
                                   const ClaimRequest& request);
absl::StatusOr<ClaimTry> TakeNext(SqlConnection& db, const Queue& queue,
                                  const ClaimRequest& request);

/// Whether somebody holds another job of this work that is not to be cancelled. In a transaction,
/// until whose end nobody else claims such a job.
absl::StatusOr<bool> OthersHold(SqlConnection& db, const std::string& action_digest,
                                const std::string& but_job, int64_t now_us);

absl::StatusOr<std::vector<HeldJob>> RenewLeases(SqlConnection& db,
                                                 const std::vector<Lease>& leases,
                                                 int64_t until_us);

/// The statements, for a test of how they are planned.
std::string TenantsSql(const SqlDialect& dialect);
std::string ClaimableSql(const SqlDialect& dialect);

}  // namespace slicefarm::coordinator
