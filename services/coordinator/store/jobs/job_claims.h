#pragma once

#include <cstdint>
#include <optional>
#include <set>
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
  std::set<std::string> busy;
  Priority at_least = Priority::kBulk;
};

/// Whether there may be something to claim. Cost: one look into an index a tenant.
absl::StatusOr<bool> AnyClaimable(SqlConnection& db, const ClaimRequest& request);

/// In a transaction.
absl::StatusOr<std::optional<Lease>> ClaimJob(SqlConnection& db, const ClaimRequest& request);
absl::StatusOr<std::vector<HeldJob>> RenewLeases(SqlConnection& db,
                                                 const std::vector<Lease>& leases,
                                                 int64_t until_us);

/// The statements, for a test of how they are planned.
std::string TenantsSql(const SqlDialect& dialect);
std::string ClaimableSql(const SqlDialect& dialect, const ClaimRequest& request);

}  // namespace slicefarm::coordinator
