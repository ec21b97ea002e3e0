#include "services/coordinator/store/jobs/job_queue.h"

#include <map>
#include <set>

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/jobs/job_rows.h"
#include "services/coordinator/store/jobs/sql_job_store.h"

namespace slicefarm::coordinator {
namespace {

/// Adds the held jobs to the queue. Returns their numbers.
absl::StatusOr<std::set<int64_t>> AddHeld(SqlConnection& db, int64_t now_us, QueueSnapshot& queue) {
  const std::string sql = HeldSql(db.dialect());
  SqlQuery query(db, sql);
  query.Bind(now_us);
  std::set<int64_t> numbers;
  while (query.Next()) {
    numbers.insert(query.Int(0));
    queue.held.push_back(
        {.tenant = query.Text(1),
         .owner = query.Text(2),
         .interactive = query.Int(3) == static_cast<int64_t>(Priority::kInteractive),
         .start_us = query.Int(4)});
    if (query.Int(5) == 0) queue.held_work.insert(query.Text(6));
  }
  if (!query.status().ok()) return query.status();
  return numbers;
}

absl::StatusOr<std::map<std::string, int64_t>> TurnsOf(SqlConnection& db) {
  SqlQuery query(db, "SELECT tenant, claimed_us FROM tenants");
  std::map<std::string, int64_t> turns;
  while (query.Next()) turns[query.Text(0)] = query.Int(1);
  if (!query.status().ok()) return query.status();
  return turns;
}

absl::Status AddWaiting(SqlConnection& db, const std::set<int64_t>& held, QueueSnapshot& queue) {
  const auto turns = TurnsOf(db);
  if (!turns.ok()) return turns.status();
  const std::string sql = WaitingSql(db.dialect());
  SqlQuery query(db, sql);
  while (query.Next()) {
    const int64_t number = query.Int(2);
    if (held.contains(number)) continue;
    std::string tenant = query.Text(0);
    if (queue.tenants.empty() || queue.tenants.back().tenant != tenant) {
      const auto turn = turns->find(tenant);
      queue.tenants.push_back({std::move(tenant), turn == turns->end() ? 0 : turn->second, {}});
    }
    const bool interactive = query.Int(1) == static_cast<int64_t>(Priority::kInteractive);
    queue.tenants.back().waiting.push_back({number, interactive});
  }
  return query.status();
}

absl::Status AddRuns(SqlConnection& db, QueueSnapshot& queue) {
  const std::string sql = LatestRunsSql(db.dialect());
  SqlQuery query(db, sql);
  query.Bind(kLatestRuns);
  while (query.Next())
    if (query.Int(0) > 0) queue.runs_us.push_back(query.Int(1) - query.Int(0));
  return query.status();
}

}  // namespace

/// Returns the SQL for the waiting jobs, which reads only the index.
std::string WaitingSql(const SqlDialect& dialect) {
  return absl::StrCat("SELECT tenant, priority, number FROM jobs", dialect.Through("jobs_open"),
                      " WHERE " SLICEFARM_OPEN
                      " ORDER BY tenant, priority DESC, deadline_us, number");
}

std::string HeldSql(const SqlDialect& dialect) {
  return absl::StrCat(
      "SELECT number, tenant, owner, priority, start_us, cancel_requested, action_digest FROM jobs",
      dialect.Through("jobs_held"),
      " WHERE " SLICEFARM_OPEN
      " AND owner <> '' AND owner_until_us > ? ORDER BY start_us = 0, start_us, number");
}

std::string LatestRunsSql(const SqlDialect& dialect) {
  return absl::StrCat("SELECT start_us, end_us FROM jobs", dialect.Through("jobs_by_end"),
                      " WHERE end_us > 0 ORDER BY end_us DESC, number DESC LIMIT ?");
}

absl::StatusOr<QueueSnapshot> ReadQueue(SqlConnection& db, int64_t now_us) {
  QueueSnapshot queue;
  const auto held = AddHeld(db, now_us, queue);
  if (!held.ok()) return held.status();
  if (absl::Status added = AddWaiting(db, *held, queue); !added.ok()) return added;
  if (absl::Status added = AddRuns(db, queue); !added.ok()) return added;
  return queue;
}

absl::StatusOr<QueueSnapshot> SqlJobStore::ReadQueue(int64_t now_us) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return coordinator::ReadQueue(**session, now_us);
}

}  // namespace slicefarm::coordinator
