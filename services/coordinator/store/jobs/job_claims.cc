#include "services/coordinator/store/jobs/job_claims.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/jobs/job_rows.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the tenants with open jobs that match the request; the tenant that is next in turn comes
/// first.
absl::StatusOr<std::vector<std::string>> TenantsInTurn(SqlConnection& db,
                                                       const ClaimRequest& request) {
  const std::string sql = TenantsSql(db.dialect());
  SqlQuery query(db, sql);
  query.Bind(request.now_us);
  std::vector<std::string> tenants;
  while (query.Next()) {
    const bool idle = query.Int(1) == 0;
    if (idle || !request.filter.of_idle_tenants) tenants.push_back(query.Text(0));
  }
  if (!query.status().ok()) return query.status();
  return tenants;
}

/// Returns the SQL for the action digests of held jobs. A held job that is to be cancelled is not
/// included, because it will have no result to wait for.
std::string HeldWorkSql(const SqlDialect& dialect) {
  return absl::StrCat("SELECT action_digest FROM jobs", dialect.Through("jobs_held_work"),
                      " WHERE " SLICEFARM_OPEN
                      " AND owner <> '' AND owner_until_us > ? AND cancel_requested = 0");
}

absl::StatusOr<std::optional<Candidate>> FindClaimable(SqlConnection& db, const std::string& tenant,
                                                       const ClaimRequest& request,
                                                       std::string_view locking) {
  const std::string sql = absl::StrCat(ClaimableSql(db.dialect()), std::string(locking));
  SqlQuery query(db, sql);
  query.Bind(tenant, static_cast<int64_t>(request.filter.at_least), request.now_us, request.now_us);
  std::optional<Candidate> candidate;
  while (query.Next()) candidate = {query.Int(0), query.Text(1)};
  if (!query.status().ok()) return query.status();
  return candidate;
}

/// Locks all jobs with this action digest: until the transaction ends, no other claim takes one of
/// them.
absl::Status LockWork(SqlConnection& db, const std::string& action_digest) {
  const std::string_view lock = db.dialect().lock_work;
  if (lock.empty()) return absl::OkStatus();
  return SqlQuery(db, lock).Bind(action_digest).Run();
}

constexpr std::string_view kTurn =
    " ON CONFLICT (tenant) DO UPDATE SET claimed_us = excluded.claimed_us";

std::string TakeSql(const SqlDialect& dialect, std::string_view columns) {
  return absl::StrCat(
      "UPDATE jobs SET owner = ?, owner_epoch = owner_epoch + 1, owner_until_us = ?"
      " WHERE number = (SELECT number FROM jobs WHERE number = ? AND " SLICEFARM_OPEN
      " AND owner_until_us <= ?",
      std::string(dialect.skip_locked), ") AND (cancel_requested <> 0 OR action_digest NOT IN (",
      HeldWorkSql(dialect), ")) RETURNING ", std::string(columns));
}

/// Returns the SQL that claims a job as TakeSql does and also records the turn of its tenant.
std::string TakeInTurnSql(const SqlDialect& dialect) {
  return absl::StrCat("WITH taken AS (", TakeSql(dialect, "*"),
                      "), turn AS (INSERT INTO tenants (tenant, claimed_us)"
                      " SELECT tenant, CAST(? AS BIGINT) FROM taken",
                      std::string(kTurn), ") SELECT ", JobColumns(dialect), " FROM taken");
}

absl::Status NoteTurn(SqlConnection& db, const std::string& tenant, int64_t now_us) {
  const std::string sql =
      absl::StrCat("INSERT INTO tenants (tenant, claimed_us) VALUES (?, ?)", std::string(kTurn));
  return SqlQuery(db, sql).Bind(tenant, now_us).Run();
}

/// Claims a candidate. Returns nullopt if this job, or a job of the same work, was claimed after
/// the candidate was found. The statement begins after the work is locked, and so sees all earlier
/// claims.
absl::StatusOr<std::optional<Claimed>> Take(SqlConnection& db, const Candidate& candidate,
                                            const ClaimRequest& request) {
  if (absl::Status locked = LockWork(db, candidate.action_digest); !locked.ok()) return locked;
  const SqlDialect& dialect = db.dialect();
  const std::string sql =
      dialect.writes_in_with ? TakeInTurnSql(dialect) : TakeSql(dialect, JobColumns(dialect));
  SqlQuery take(db, sql);
  take.Bind(request.owner, request.until_us, candidate.number, request.now_us, request.now_us);
  if (dialect.writes_in_with) take.Bind(request.now_us);
  std::optional<Claimed> claimed;
  while (take.Next()) {
    // An unreadable row is held as well, so that it does not block other jobs.
    claimed.emplace();
    claimed->read = ReadJob(take, claimed->job);
  }
  if (!take.status().ok()) return take.status();
  if (!claimed || dialect.writes_in_with) return claimed;
  absl::Status noted = NoteTurn(db, claimed->job.tenant, request.now_us);
  if (!noted.ok()) return noted;
  return claimed;
}

}  // namespace

/// Returns the SQL for the tenants in turn. It steps from tenant to tenant through the index of
/// open jobs and does not read their jobs.
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
      " SELECT o.tenant, (SELECT count(*) FROM jobs h",
      dialect.Through("jobs_held"),
      " WHERE h.tenant = o.tenant AND h." SLICEFARM_OPEN
      "  AND h.owner <> '' AND h.owner_until_us > ?) AS held"
      " FROM open_tenants o LEFT JOIN tenants t ON t.tenant = o.tenant"
      " WHERE o.tenant IS NOT NULL ORDER BY held, coalesce(t.claimed_us, 0), o.tenant");
}

std::string ClaimableSql(const SqlDialect& dialect) {
  return absl::StrCat("SELECT number, action_digest FROM jobs", dialect.Through("jobs_open"),
                      " WHERE tenant = ? AND " SLICEFARM_OPEN
                      " AND priority >= ? AND owner_until_us <= ?"
                      " AND (cancel_requested <> 0 OR action_digest NOT IN (",
                      HeldWorkSql(dialect),
                      ")) ORDER BY priority DESC, deadline_us, number LIMIT 1");
}

absl::StatusOr<std::optional<Queue>> FindQueue(SqlConnection& db, const ClaimRequest& request) {
  auto tenants = TenantsInTurn(db, request);
  if (!tenants.ok()) return tenants.status();
  for (auto tenant = tenants->begin(); tenant != tenants->end(); ++tenant) {
    auto found = FindClaimable(db, *tenant, request, "");
    if (!found.ok()) return found.status();
    if (*found) return Queue{**std::move(found), {tenant, tenants->end()}};
  }
  return std::nullopt;
}

absl::StatusOr<ClaimTry> TakeFirst(SqlConnection& db, const Queue& queue,
                                   const ClaimRequest& request) {
  auto claimed = Take(db, queue.first, request);
  if (!claimed.ok()) return claimed.status();
  return ClaimTry{*std::move(claimed)};
}

absl::StatusOr<ClaimTry> TakeNext(SqlConnection& db, const Queue& queue,
                                  const ClaimRequest& request) {
  for (const std::string& tenant : queue.tenants) {
    const auto found = FindClaimable(db, tenant, request, db.dialect().skip_locked);
    if (!found.ok()) return found.status();
    if (!*found) continue;
    auto claimed = Take(db, **found, request);
    if (!claimed.ok()) return claimed.status();
    return ClaimTry{*std::move(claimed)};
  }
  return ClaimTry{.nothing_left = true};
}

absl::StatusOr<bool> OthersHold(SqlConnection& db, const std::string& action_digest,
                                const std::string& but_job, int64_t now_us) {
  if (absl::Status locked = LockWork(db, action_digest); !locked.ok()) return locked;
  const std::string sql = absl::StrCat("SELECT 1 WHERE EXISTS (", HeldWorkSql(db.dialect()),
                                       " AND action_digest = ? AND id <> ?)");
  SqlQuery query(db, sql);
  const bool others = query.Bind(now_us, action_digest, but_job).Next();
  if (!query.status().ok()) return query.status();
  return others;
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
                   " AND owner <> '' AND " SLICEFARM_OPEN
                   " RETURNING cancel_requested, deadline_us");
    renew.Bind(until_us, until_us, lease.job_id, lease.epoch);
    while (renew.Next()) held.push_back({lease, renew.Int(0) != 0, renew.Int(1)});
    if (!renew.status().ok()) return renew.status();
  }
  return held;
}

}  // namespace slicefarm::coordinator
