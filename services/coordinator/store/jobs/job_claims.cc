#include "services/coordinator/store/jobs/job_claims.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/jobs/job_rows.h"

namespace slicefarm::coordinator {
namespace {

/// Tenants with open jobs, those whose turn it is first.
absl::StatusOr<std::vector<std::string>> TenantsInTurn(SqlConnection& db, int64_t now_us) {
  const std::string sql = TenantsSql(db.dialect());
  SqlQuery query(db, sql);
  query.Bind(now_us);
  std::vector<std::string> tenants;
  while (query.Next()) tenants.push_back(query.Text(0));
  if (!query.status().ok()) return query.status();
  return tenants;
}

void BindClaimable(SqlQuery& query, const std::string& tenant, const ClaimRequest& request) {
  query.Bind(tenant, static_cast<int64_t>(request.at_least), request.now_us);
  for (const std::string& digest : request.busy) query.Bind(digest);
}

absl::StatusOr<std::optional<Lease>> ClaimOf(SqlConnection& db, const std::string& tenant,
                                             const ClaimRequest& request) {
  const std::string sql = absl::StrCat(
      "UPDATE jobs SET owner = ?, owner_epoch = owner_epoch + 1, owner_until_us = ?"
      " WHERE number = (",
      ClaimableSql(db.dialect(), request), std::string(db.dialect().skip_locked),
      ") RETURNING id, owner_epoch");
  SqlQuery claim(db, sql);
  claim.Bind(request.owner, request.until_us);
  BindClaimable(claim, tenant, request);
  std::optional<Lease> lease;
  while (claim.Next()) lease = {claim.Text(0), claim.Int(1)};
  if (!claim.status().ok()) return claim.status();
  return lease;
}

absl::Status NoteTurn(SqlConnection& db, const std::string& tenant, int64_t now_us) {
  SqlQuery note(db,
                "INSERT INTO tenants (tenant, claimed_us) VALUES (?, ?)"
                " ON CONFLICT (tenant) DO UPDATE SET claimed_us = excluded.claimed_us");
  return note.Bind(tenant, now_us).Run();
}

}  // namespace

/// Goes from tenant to tenant through the index of open jobs, whose jobs it need not read.
std::string TenantsSql(const SqlDialect& dialect) {
  const std::string open = dialect.Through("jobs_open");
  return absl::StrCat(
      "WITH RECURSIVE open_tenants (tenant) AS ("
      " SELECT min(tenant) FROM jobs",
      open,
      " WHERE " SLICEFARM_OPEN
      " UNION ALL"
      " SELECT (SELECT min(j.tenant) FROM jobs j",
      open,
      " WHERE j." SLICEFARM_OPEN
      "  AND j.tenant > o.tenant) FROM open_tenants o WHERE o.tenant IS NOT NULL)"
      " SELECT o.tenant FROM open_tenants o LEFT JOIN tenants t ON t.tenant = o.tenant"
      " WHERE o.tenant IS NOT NULL"
      " ORDER BY (SELECT count(*) FROM jobs h",
      dialect.Through("jobs_held"),
      " WHERE h.tenant = o.tenant AND h." SLICEFARM_OPEN
      "  AND h.owner <> '' AND h.owner_until_us > ?),"
      " coalesce(t.claimed_us, 0), o.tenant");
}

std::string ClaimableSql(const SqlDialect& dialect, const ClaimRequest& request) {
  std::string sql = absl::StrCat("SELECT number FROM jobs", dialect.Through("jobs_open"),
                                 " WHERE tenant = ? AND " SLICEFARM_OPEN
                                 " AND priority >= ? AND owner_until_us <= ?");
  const char* next = " AND action_digest NOT IN (?";
  for (size_t i = 0; i < request.busy.size(); ++i) {
    sql += next;
    next = ", ?";
  }
  if (!request.busy.empty()) sql += ")";
  return sql + " ORDER BY priority DESC, deadline_us, number LIMIT 1";
}

absl::StatusOr<bool> AnyClaimable(SqlConnection& db, const ClaimRequest& request) {
  const auto tenants = TenantsInTurn(db, request.now_us);
  if (!tenants.ok()) return tenants.status();
  const std::string sql = ClaimableSql(db.dialect(), request);
  for (const std::string& tenant : *tenants) {
    SqlQuery query(db, sql);
    BindClaimable(query, tenant, request);
    if (query.Next()) return true;
    if (!query.status().ok()) return query.status();
  }
  return false;
}

absl::StatusOr<std::optional<Lease>> ClaimJob(SqlConnection& db, const ClaimRequest& request) {
  const auto tenants = TenantsInTurn(db, request.now_us);
  if (!tenants.ok()) return tenants.status();
  for (const std::string& tenant : *tenants) {
    auto lease = ClaimOf(db, tenant, request);
    if (!lease.ok()) return lease.status();
    if (!*lease) continue;
    if (absl::Status noted = NoteTurn(db, tenant, request.now_us); !noted.ok()) return noted;
    return lease;
  }
  return std::nullopt;
}

absl::StatusOr<std::vector<HeldJob>> RenewLeases(SqlConnection& db,
                                                 const std::vector<Lease>& leases,
                                                 int64_t until_us) {
  std::vector<HeldJob> held;
  for (const Lease& lease : leases) {
    SqlQuery renew(db,
                   "UPDATE jobs SET owner_until_us ="
                   " CASE WHEN owner_until_us > ? THEN owner_until_us ELSE ? END"
                   " WHERE id = ? AND owner_epoch = ?"
                   " AND owner <> '' AND " SLICEFARM_OPEN " RETURNING cancel_requested");
    renew.Bind(until_us, until_us, lease.job_id, lease.epoch);
    while (renew.Next()) held.push_back({lease, renew.Int(0) != 0});
    if (!renew.status().ok()) return renew.status();
  }
  return held;
}

}  // namespace slicefarm::coordinator
