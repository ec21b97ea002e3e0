#include "services/coordinator/store/sqlite_job_store.h"

#include <fmt/format.h>

#include <utility>

#include "common/model/error.h"
#include "services/coordinator/store/job_steps.h"
#include "services/coordinator/store/sqlite_job_rows.h"
#include "services/coordinator/store/sqlite_schema.h"

namespace slicefarm::coordinator {
namespace {

using Lock = std::lock_guard<std::mutex>;

/// The job that an earlier call with the same request id made, if there was one.
absl::StatusOr<std::optional<JobRecord>> FindRequested(SqliteConnection& db, const NewJob& job) {
  SqliteQuery query(db, "SELECT job_id, spec_digest FROM requests WHERE request_id = ?");
  query.Bind(job.request_id);
  if (!query.Next()) {
    if (!query.status().ok()) return query.status();
    return std::nullopt;
  }
  if (query.Text(1) != job.spec_digest) return RequestIdReused(job.request_id);
  auto found = FindJob(db, query.Text(0));
  if (!found.ok()) return found.status();
  return *std::move(found);
}

absl::Status InsertJob(SqliteConnection& db, const NewJob& job, int64_t now_us) {
  SqliteQuery insert(db,
                     "INSERT INTO jobs (id, state, spec, labels, settings_digest, action_digest,"
                     " build_id, create_us) VALUES (?, 'QUEUED', ?, ?, ?, ?, ?, ?)");
  insert.Bind(job.id, Blob{job.spec}, ToJson(job.labels), job.settings_digest, job.action_digest,
              job.build_id, now_us);
  if (absl::Status done = insert.Run(); !done.ok()) return done;
  if (job.request_id.empty()) return absl::OkStatus();
  SqliteQuery remember(
      db, "INSERT INTO requests (request_id, job_id, spec_digest, create_us) VALUES (?, ?, ?, ?)");
  return remember.Bind(job.request_id, job.id, job.spec_digest, now_us).Run();
}

absl::StatusOr<bool> AnyClaimable(SqliteConnection& db, int64_t now_us, const std::string& busy) {
  SqliteQuery query(db, kAnyClaimableSql);
  const bool any = query.Bind(now_us, busy).Next();
  if (!query.status().ok()) return query.status();
  return any;
}

/// What a result has to do with the index of results.
absl::Status IndexResult(SqliteConnection& db, const JobRecord& job) {
  const JobResult& result = *job.result;
  if (result.cached) {
    SqliteQuery query(db, "SELECT 1 FROM results WHERE action_digest = ? AND gcode_sha256 = ?");
    query.Bind(job.action_digest, result.gcode_sha256);
    if (query.Next()) return absl::OkStatus();
    return query.status().ok() ? CachedResultGone(job.id) : query.status();
  }
  SqliteQuery insert(db,
                     "INSERT OR REPLACE INTO results (action_digest, result, gcode_sha256,"
                     " report_sha256) VALUES (?, ?, ?, ?)");
  return insert.Bind(job.action_digest, ToJson(result), result.gcode_sha256, result.report_sha256)
      .Run();
}

/// `digest` if no job refers to it any more; results made of it leave the index.
absl::Status DropUnreferenced(SqliteConnection& db, const std::string& digest,
                              std::vector<std::string>& dropped) {
  if (digest.empty()) return absl::OkStatus();
  SqliteQuery query(
      db,
      "SELECT EXISTS (SELECT 1 FROM jobs WHERE gcode_sha256 = ?1 AND gcode_sha256 <> '')"
      " OR EXISTS (SELECT 1 FROM jobs WHERE report_sha256 = ?1 AND report_sha256 <> '')");
  query.Bind(digest);
  const bool referenced = query.Next() && query.Int(0) != 0;
  if (!query.status().ok() || referenced) return query.status();
  dropped.push_back(digest);
  SqliteQuery forget(db, "DELETE FROM results WHERE gcode_sha256 = ?1 OR report_sha256 = ?1");
  return forget.Bind(digest).Run();
}

}  // namespace

absl::StatusOr<std::unique_ptr<SqliteJobStore>> SqliteJobStore::Open(const std::string& path) {
  auto writer = SqliteConnection::Open(path);
  if (!writer.ok()) return writer.status();
  if (absl::Status ready = MigrateSqlite(**writer); !ready.ok()) return ready;
  auto reader = SqliteConnection::Open(path);
  if (!reader.ok()) return reader.status();
  return std::unique_ptr<SqliteJobStore>(
      new SqliteJobStore(*std::move(writer), *std::move(reader)));
}

absl::StatusOr<Created> SqliteJobStore::Create(const NewJob& job, int64_t now_us) {
  Lock lock(write_mutex_);
  SqliteTransaction transaction(*writer_);
  if (!transaction.status().ok()) return transaction.status();
  if (!job.request_id.empty()) {
    auto earlier = FindRequested(*writer_, job);
    if (!earlier.ok()) return earlier.status();
    if (*earlier) return Created{**std::move(earlier), /*fresh=*/false};
  }
  if (absl::Status done = InsertJob(*writer_, job, now_us); !done.ok()) return done;
  auto record = FindJob(*writer_, job.id);
  if (!record.ok()) return record.status();
  if (absl::Status done = WriteStep(*writer_, *record, now_us); !done.ok()) return done;
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return Created{*std::move(record), /*fresh=*/true};
}

absl::StatusOr<JobRecord> SqliteJobStore::Get(const std::string& id) {
  Lock lock(read_mutex_);
  return FindJob(*reader_, id);
}

absl::StatusOr<std::vector<JobRecord>> SqliteJobStore::List(const ListQuery& list) {
  Lock lock(read_mutex_);
  // The set of states as a mask keeps this one prepared statement.
  SqliteQuery query(*reader_, "SELECT " SLICEFARM_JOB_COLUMNS
                              " FROM jobs WHERE (?1 = 0 OR number < ?1) AND (?2 = ''"
                              " OR instr(?2, '|' || state || '|') > 0)"
                              " ORDER BY number DESC LIMIT ?3");
  std::string states;
  for (const JobState state : list.states) states += fmt::format("|{}|", JobStateName(state));
  query.Bind(list.before_number, states, list.limit);
  return ReadJobs(query);
}

absl::StatusOr<std::optional<JobRecord>> SqliteJobStore::Claim(const std::string& owner,
                                                               int64_t now_us, int64_t until_us,
                                                               const std::set<std::string>& busy) {
  const std::string busy_json = ToJson(busy);
  Lock lock(write_mutex_);
  // Most calls find nothing, and need no write.
  const auto any = AnyClaimable(*writer_, now_us, busy_json);
  if (!any.ok()) return any.status();
  if (!*any) return std::nullopt;
  SqliteQuery claim(*writer_, kClaimJobSql);
  claim.Bind(owner, until_us, now_us, busy_json);
  auto jobs = ReadJobs(claim);
  if (!jobs.ok()) return jobs.status();
  if (jobs->empty()) return std::nullopt;
  return std::move(jobs->front());
}

absl::Status SqliteJobStore::Adopt(const Lease& lease, const JobIdentity& identity) {
  Lock lock(write_mutex_);
  SqliteQuery adopt(*writer_,
                    "UPDATE jobs SET settings_digest = ?, action_digest = ?, build_id = ?"
                    " WHERE id = ? AND owner_epoch = ? AND owner <> '' RETURNING id");
  adopt.Bind(identity.settings_digest, identity.action_digest, identity.build_id, lease.job_id,
             lease.epoch);
  bool held = false;
  while (adopt.Next()) held = true;  // to the end, where it is committed
  if (!adopt.status().ok() || held) return adopt.status();
  return NotHeld(lease);
}

absl::StatusOr<std::vector<HeldJob>> SqliteJobStore::Renew(const std::vector<Lease>& leases,
                                                           int64_t until_us) {
  std::vector<HeldJob> held;
  if (leases.empty()) return held;
  Lock lock(write_mutex_);
  SqliteTransaction transaction(*writer_);
  if (!transaction.status().ok()) return transaction.status();
  for (const Lease& lease : leases) {
    SqliteQuery renew(*writer_,
                      "UPDATE jobs SET owner_until_us = ? WHERE id = ? AND owner_epoch = ?"
                      " AND owner <> '' AND state IN ('QUEUED', 'RUNNING')"
                      " RETURNING cancel_requested");
    renew.Bind(until_us, lease.job_id, lease.epoch);
    while (renew.Next()) held.push_back({lease, renew.Int(0) != 0});
    if (!renew.status().ok()) return renew.status();
  }
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return held;
}

absl::Status SqliteJobStore::Release(const std::string& owner) {
  Lock lock(write_mutex_);
  SqliteQuery release(*writer_, "UPDATE jobs SET owner = '', owner_until_us = 0 WHERE owner = ?");
  return release.Bind(owner).Run();
}

absl::StatusOr<JobRecord> SqliteJobStore::Update(const Lease& lease, const JobUpdate& update,
                                                 int64_t now_us) {
  Lock lock(write_mutex_);
  SqliteTransaction transaction(*writer_);
  if (!transaction.status().ok()) return transaction.status();
  auto job = FindJob(*writer_, lease.job_id);
  if (!job.ok()) return job.status();
  if (absl::Status done = ApplyUpdate(*job, lease, update, now_us); !done.ok()) return done;
  if (job->result) {
    if (absl::Status done = IndexResult(*writer_, *job); !done.ok()) return done;
  }
  if (absl::Status done = WriteStep(*writer_, *job, now_us); !done.ok()) return done;
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return job;
}

absl::StatusOr<JobRecord> SqliteJobStore::RequestCancel(const std::string& id, int64_t now_us) {
  Lock lock(write_mutex_);
  SqliteTransaction transaction(*writer_);
  if (!transaction.status().ok()) return transaction.status();
  auto job = FindJob(*writer_, id);
  if (!job.ok()) return job.status();
  if (!ApplyCancel(*job, now_us)) return job;
  if (absl::Status done = WriteStep(*writer_, *job, now_us); !done.ok()) return done;
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return job;
}

absl::StatusOr<std::vector<std::string>> SqliteJobStore::Delete(const std::string& id) {
  Lock lock(write_mutex_);
  SqliteTransaction transaction(*writer_);
  if (!transaction.status().ok()) return transaction.status();
  const auto job = FindJob(*writer_, id);
  if (!job.ok()) return job.status();
  if (!IsTerminal(job->state)) return JobNotFinished(id);
  SqliteQuery forget(*writer_, "DELETE FROM requests WHERE job_id = ?");
  if (absl::Status done = forget.Bind(id).Run(); !done.ok()) return done;
  SqliteQuery remove(*writer_, "DELETE FROM jobs WHERE number = ?");
  if (absl::Status done = remove.Bind(job->number).Run(); !done.ok()) return done;
  std::vector<std::string> dropped;
  if (job->result) {
    for (const std::string& digest : {job->result->gcode_sha256, job->result->report_sha256}) {
      if (absl::Status done = DropUnreferenced(*writer_, digest, dropped); !done.ok()) return done;
    }
  }
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return dropped;
}

absl::StatusOr<std::vector<JobEventRecord>> SqliteJobStore::Events(const std::string& id,
                                                                   int64_t after, int32_t limit) {
  Lock lock(read_mutex_);
  const auto job = FindJob(*reader_, id);
  if (!job.ok()) return job.status();
  SqliteQuery query(*reader_,
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

absl::StatusOr<std::optional<JobResult>> SqliteJobStore::FindResult(
    const std::string& action_digest) {
  Lock lock(read_mutex_);
  SqliteQuery query(*reader_, "SELECT result FROM results WHERE action_digest = ?");
  query.Bind(action_digest);
  if (!query.Next()) {
    if (!query.status().ok()) return query.status();
    return std::nullopt;
  }
  JobResult result;
  if (absl::Status read = FromJson(query.Text(0), result); !read.ok()) return read;
  return result;
}

absl::Status SqliteJobStore::ForgetResult(const std::string& action_digest) {
  Lock lock(write_mutex_);
  return SqliteQuery(*writer_, "DELETE FROM results WHERE action_digest = ?")
      .Bind(action_digest)
      .Run();
}

absl::Status SqliteJobStore::ExpireRequestIds(int64_t now_us) {
  Lock lock(write_mutex_);
  return SqliteQuery(*writer_, "DELETE FROM requests WHERE create_us < ?")
      .Bind(now_us - kRequestIdKeptUs)
      .Run();
}

absl::StatusOr<std::map<JobState, int64_t>> SqliteJobStore::CountByState() {
  Lock lock(read_mutex_);
  SqliteQuery query(*reader_, "SELECT state, count(*) FROM jobs GROUP BY state");
  std::map<JobState, int64_t> counts;
  while (query.Next()) {
    if (const auto state = JobStateFromName(query.Text(0))) counts[*state] = query.Int(1);
  }
  if (!query.status().ok()) return query.status();
  return counts;
}

}  // namespace slicefarm::coordinator
