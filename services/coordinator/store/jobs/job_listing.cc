#include "services/coordinator/store/jobs/job_listing.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/jobs/job_rows.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the SQL of a list. It contains only the requested conditions, so that a suitable index
/// is used.
std::string ListSql(const SqlDialect& dialect, const ListQuery& list) {
  std::string sql = absl::StrCat("SELECT ", JobColumns(dialect), " FROM jobs WHERE TRUE");
  if (!list.all_tenants) sql += " AND tenant = ?";
  if (list.after_number > 0) sql += list.oldest_first ? " AND number > ?" : " AND number < ?";
  if (list.priority) sql += " AND priority = ?";
  if (list.created_from_us > 0) sql += " AND create_us >= ?";
  if (list.created_before_us < INT64_MAX) sql += " AND create_us < ?";
  for (size_t i = 0; i < list.states.size(); ++i) sql += i == 0 ? " AND state IN (?" : ", ?";
  if (!list.states.empty()) sql += ")";
  for (size_t i = 0; i < list.labels.size(); ++i)
    sql += " AND number IN (SELECT job FROM labels WHERE key = ? AND value = ?)";
  absl::StrAppend(&sql, " ORDER BY number ", list.oldest_first ? "ASC" : "DESC", " LIMIT ?");
  return sql;
}

/// Rows per statement. PostgreSQL sends all rows of a statement at once, and each row has its spec.
constexpr int32_t kRowsAtOnce = 16;

/// Appends the result of one statement to `jobs`, and the size of their specs to `bytes`. Returns
/// false if it was the last part of the list.
absl::StatusOr<bool> AppendJobs(SqlConnection& db, const ListQuery& list,
                                std::vector<JobRecord>& jobs, int64_t& bytes) {
  const std::string sql = ListSql(db.dialect(), list);
  SqlQuery query(db, sql);
  if (!list.all_tenants) query.Bind(list.tenant);
  if (list.after_number > 0) query.Bind(list.after_number);
  if (list.priority) query.Bind(static_cast<int64_t>(*list.priority));
  if (list.created_from_us > 0) query.Bind(list.created_from_us);
  if (list.created_before_us < INT64_MAX) query.Bind(list.created_before_us);
  for (const JobState state : list.states) query.Bind(JobStateName(state));
  for (const auto& [key, value] : list.labels) query.Bind(key, value);
  query.Bind(list.limit);
  int32_t count = 0;
  for (; bytes < kListedSpecBytes && query.Next(); ++count) {
    JobRecord& job = jobs.emplace_back();
    // A damaged job stays in the list with an error, so that the remaining jobs can be listed.
    if (absl::Status read = ReadJob(query, job); !read.ok()) job.error = JobErrorOf(read);
    bytes += std::ssize(job.spec);
  }
  if (!query.status().ok()) return query.status();
  return bytes < kListedSpecBytes && count == list.limit;
}

}  // namespace

absl::StatusOr<std::vector<JobRecord>> ListJobs(SqlConnection& db, const ListQuery& list) {
  std::vector<JobRecord> jobs;
  int64_t bytes = 0;
  ListQuery part = list;
  for (absl::StatusOr<bool> more = true; *more && std::ssize(jobs) < list.limit;) {
    part.limit = std::min(kRowsAtOnce, list.limit - static_cast<int32_t>(std::ssize(jobs)));
    if (!jobs.empty()) part.after_number = jobs.back().number;
    more = AppendJobs(db, part, jobs, bytes);
    if (!more.ok()) return more.status();
  }
  return jobs;
}

absl::StatusOr<std::vector<JobEventRecord>> ListEvents(SqlConnection& db, const std::string& id,
                                                       int64_t after, int32_t limit) {
  const auto job = FindJobWithoutSpec(db, id);
  if (!job.ok()) return job.status();
  SqlQuery query(db,
                 "SELECT sequence, time_us, state, layers_total, layers_done FROM events"
                 " WHERE job = ? AND sequence > ? ORDER BY sequence LIMIT ?");
  query.Bind(job->number, after, limit);
  std::vector<JobEventRecord> events;
  while (query.Next()) {
    events.push_back({.sequence = query.Int(0),
                      .time_us = query.Int(1),
                      .state = JobStateFromName(query.Text(2)).value_or(job->state),
                      .layers_total = static_cast<int32_t>(query.Int(3)),
                      .layers_done = static_cast<int32_t>(query.Int(4))});
  }
  if (!query.status().ok()) return query.status();
  return events;
}

absl::StatusOr<std::vector<TenantEvent>> ListEventsOf(SqlConnection& db, const std::string& tenant,
                                                      const EventCursor& after, int32_t limit) {
  SqlQuery query(db,
                 "SELECT jobs.id, events.time_us, events.job, events.sequence, events.state,"
                 " events.layers_total, events.layers_done"
                 " FROM events JOIN jobs ON jobs.number = events.job"
                 " WHERE (events.time_us, events.job, events.sequence) > (?, ?, ?)"
                 " AND jobs.tenant = ?"
                 " ORDER BY events.time_us, events.job, events.sequence LIMIT ?");
  query.Bind(after.time_us, after.number, after.sequence, tenant, limit);
  std::vector<TenantEvent> events;
  while (query.Next()) {
    TenantEvent& event = events.emplace_back();
    event.job_id = query.Text(0);
    event.cursor = {query.Int(1), query.Int(2), query.Int(3)};
    event.event = {.sequence = event.cursor.sequence,
                   .time_us = event.cursor.time_us,
                   .state = JobStateFromName(query.Text(4)).value_or(JobState::kQueued),
                   .layers_total = static_cast<int32_t>(query.Int(5)),
                   .layers_done = static_cast<int32_t>(query.Int(6))};
  }
  if (!query.status().ok()) return query.status();
  return events;
}

}  // namespace slicefarm::coordinator
