#include "services/coordinator/store/jobs/sql_job_store.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "common/base/error.h"
#include "services/coordinator/store/jobs/job_chores.h"
#include "services/coordinator/store/jobs/job_claims.h"
#include "services/coordinator/store/jobs/job_creation.h"
#include "services/coordinator/store/jobs/job_listing.h"
#include "services/coordinator/store/jobs/job_rows.h"
#include "services/coordinator/store/jobs/job_steps.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"
#include "services/coordinator/store/sql/sqlite_database.h"

namespace slicefarm::coordinator {
namespace {

/// Adds the result of a job to the index of results, or checks that a cached result is in it.
absl::Status IndexResult(SqlConnection& db, const JobRecord& job) {
  const JobResult& result = *job.result;
  if (result.cached) {
    // A quote has no G-code, and may share the report of a print.
    SqlQuery query(db,
                   "SELECT 1 FROM results WHERE report_sha256 = ? AND tenant = ?"
                   " AND (gcode_sha256 = ? OR '' = ?)");
    query.Bind(result.report_sha256, result.tenant, result.gcode_sha256, result.gcode_sha256);
    if (query.Next()) return absl::OkStatus();
    return query.status().ok() ? CachedResultGone(job.id) : query.status();
  }
  SqlQuery insert(db,
                  "INSERT INTO results (action_digest, result, tenant, gcode_sha256, report_sha256)"
                  " VALUES (?, ?, ?, ?, ?) ON CONFLICT (action_digest) DO UPDATE SET"
                  " result = excluded.result, tenant = excluded.tenant,"
                  " gcode_sha256 = excluded.gcode_sha256, report_sha256 = excluded.report_sha256");
  insert.Bind(job.action_digest, ToJson(result), result.tenant, result.gcode_sha256,
              result.report_sha256);
  return insert.Run();
}

/// SQL condition for artifacts of a tenant. `value` is the digest, and the tenant is bound three
/// times.
constexpr std::string_view kIsArtifact =
    "EXISTS (SELECT 1 FROM jobs WHERE gcode_sha256 = value AND gcode_sha256 <> ''"
    "  AND result_tenant = ?)"
    " OR EXISTS (SELECT 1 FROM jobs WHERE report_sha256 = value AND report_sha256 <> ''"
    "  AND result_tenant = ?)"
    " OR EXISTS (SELECT 1 FROM jobs WHERE trace_sha256 = value AND trace_sha256 <> ''"
    "  AND tenant = ?)";

/// Returns the SQL for the digests of a JSON list that fulfil a condition.
std::string OfDigests(const SqlConnection& db, std::string_view condition) {
  return absl::StrCat("SELECT value FROM ", std::string(db.dialect().texts), " WHERE ",
                      std::string(condition));
}

absl::StatusOr<std::set<std::string>> ReadDigests(SqlQuery& query) {
  std::set<std::string> digests;
  while (query.Next()) digests.insert(query.Text(0));
  if (!query.status().ok()) return query.status();
  return digests;
}

/// Returns true if a job's result refers to this blob of the tenant.
absl::StatusOr<bool> IsArtifact(SqlConnection& db, const std::string& tenant,
                                const std::string& digest) {
  SqlQuery query(db,
                 "SELECT 1 WHERE EXISTS (SELECT 1 FROM jobs WHERE gcode_sha256 = ?"
                 "  AND gcode_sha256 <> '' AND result_tenant = ?)"
                 " OR EXISTS (SELECT 1 FROM jobs WHERE report_sha256 = ?"
                 "  AND report_sha256 <> '' AND result_tenant = ?)"
                 " OR EXISTS (SELECT 1 FROM jobs WHERE trace_sha256 = ?"
                 "  AND trace_sha256 <> '' AND tenant = ?)");
  const bool referenced = query.Bind(digest, tenant, digest, tenant, digest, tenant).Next();
  if (!query.status().ok()) return query.status();
  return referenced;
}

/// Removes results from the index if no job refers to one of their blobs any more.
absl::Status ForgetUnreferenced(SqlConnection& db, const std::string& tenant,
                                const std::string& digest) {
  if (digest.empty()) return absl::OkStatus();
  const auto referenced = IsArtifact(db, tenant, digest);
  if (!referenced.ok() || *referenced) return referenced.status();
  SqlQuery forget(
      db, "DELETE FROM results WHERE tenant = ? AND (gcode_sha256 = ? OR report_sha256 = ?)");
  return forget.Bind(tenant, digest, digest).Run();
}

/// Runs `work(connection)` in a transaction.
template <typename Result, typename Work>
absl::StatusOr<Result> InTransaction(SqlDatabase& database, const Work& work) {
  const auto session = database.Write();
  if (!session.ok()) return session.status();
  SqlTransaction transaction(**session);
  if (!transaction.status().ok()) return transaction.status();
  absl::StatusOr<Result> result = work(**session);
  if (!result.ok()) return result;
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return result;
}

/// Runs one statement.
template <typename... Values>
absl::Status RunOne(SqlDatabase& database, std::string_view sql, const Values&... values) {
  const auto session = database.Write();
  if (!session.ok()) return session.status();
  return SqlQuery(**session, sql).Bind(values...).Run();
}

absl::Status DeleteIn(SqlConnection& db, const std::string& id) {
  const auto job = LockJob(db, id);
  if (!job.ok()) return job.status();
  if (!IsTerminal(job->state)) return JobNotFinished(id);
  SqlQuery forget(db, "DELETE FROM requests WHERE job_id = ?");
  if (absl::Status done = forget.Bind(id).Run(); !done.ok()) return done;
  SqlQuery remove(db, "DELETE FROM jobs WHERE number = ?");
  if (absl::Status done = remove.Bind(job->number).Run(); !done.ok()) return done;
  if (!job->result) return absl::OkStatus();
  for (const std::string& digest : {job->result->gcode_sha256, job->result->report_sha256}) {
    absl::Status done = ForgetUnreferenced(db, job->result->tenant, digest);
    if (!done.ok()) return done;
  }
  return absl::OkStatus();
}

/// Returns the ids of waiting jobs that have passed their deadlines. Cost: reads the index of open
/// jobs.
absl::StatusOr<std::vector<std::string>> ListOverdue(SqlDatabase& database, int64_t now_us,
                                                     int32_t limit) {
  const auto session = database.Read();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  const std::string sql =
      absl::StrCat("SELECT id FROM jobs", db.dialect().Through("jobs_open"),
                   " WHERE " SLICEFARM_OPEN
                   " AND deadline_us <= ? AND (owner = '' OR owner_until_us <= ?)"
                   " AND cancel_requested = 0"
                   " ORDER BY deadline_us, number LIMIT ?");
  SqlQuery query(db, sql);
  query.Bind(now_us, now_us, limit);
  std::vector<std::string> ids;
  while (query.Next()) ids.push_back(query.Text(0));
  if (!query.status().ok()) return query.status();
  return ids;
}

/// Largest number of tries of a claim if other coordinators are faster.
constexpr int kClaimTries = 20;

/// Reads rows of a state and a count.
absl::StatusOr<std::map<JobState, int64_t>> ReadCounts(SqlQuery& query) {
  std::map<JobState, int64_t> counts;
  while (query.Next()) {
    if (const auto state = JobStateFromName(query.Text(0))) counts[*state] = query.Int(1);
  }
  if (!query.status().ok()) return query.status();
  return counts;
}

/// Ends an overdue job. Returns nullopt if another transaction is writing to it, or has claimed,
/// ended or deleted it since it was listed.
absl::StatusOr<std::optional<JobRecord>> EndOverdueIn(SqlConnection& db, const std::string& id,
                                                      const JobError& error, int64_t now_us) {
  auto job = LockFreeJob(db, id);
  if (DetailOf(job.status()).reason == Reason::kJobNotFound) return std::nullopt;
  if (!job.ok()) return job.status();
  if (!ApplyOverdue(*job, error, now_us)) return std::nullopt;
  if (absl::Status done = WriteStep(db, *job, now_us); !done.ok()) return done;
  return *std::move(job);
}

}  // namespace

absl::StatusOr<Created> SqlJobStore::Create(const NewJob& job, int64_t now_us) {
  return InTransaction<Created>(*database_,
                                [&](SqlConnection& db) { return MakeJob(db, job, now_us); });
}

absl::StatusOr<std::vector<Created>> SqlJobStore::CreateAll(const std::vector<NewJob>& jobs,
                                                            int64_t now_us) {
  using All = std::vector<Created>;
  return InTransaction<All>(*database_, [&](SqlConnection& db) -> absl::StatusOr<All> {
    All all;
    for (const NewJob& job : jobs) {
      absl::StatusOr<Created> created = MakeJob(db, job, now_us);
      if (!created.ok()) return created.status();
      all.push_back(*std::move(created));
    }
    return all;
  });
}

absl::StatusOr<JobRecord> SqlJobStore::Get(const std::string& id) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return FindJob(**session, id);
}

absl::StatusOr<std::string> SqlJobStore::TenantOf(const std::string& id) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session, "SELECT tenant FROM jobs WHERE id = ?");
  if (query.Bind(id).Next()) return query.Text(0);
  return query.status().ok() ? JobNotFound(id) : query.status();
}

absl::StatusOr<std::vector<JobRecord>> SqlJobStore::List(const ListQuery& query) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return ListJobs(**session, query);
}

absl::StatusOr<std::optional<JobRecord>> SqlJobStore::Claim(const std::string& owner,
                                                            int64_t now_us, int64_t until_us,
                                                            const ClaimFilter& filter) {
  const ClaimRequest request = {owner, now_us, until_us, filter};
  // The search is a read, because usually no job is found and no write transaction is needed.
  std::optional<Queue> queue;
  {
    const auto session = database_->Read();
    if (!session.ok()) return session.status();
    auto found = FindQueue(**session, request);
    if (!found.ok()) return found.status();
    if (!*found) return std::nullopt;
    queue = *std::move(found);
  }
  for (int tries = 0; tries < kClaimTries; ++tries) {
    auto one = InTransaction<ClaimTry>(*database_, [&](SqlConnection& db) {
      return tries == 0 ? TakeFirst(db, *queue, request) : TakeNext(db, *queue, request);
    });
    if (!one.ok()) return one.status();
    if (one->nothing_left) break;
    if (!one->claimed) continue;
    if (!one->claimed->read.ok()) return one->claimed->read;
    return std::move(one->claimed->job);
  }
  return std::nullopt;
}

absl::StatusOr<std::vector<JobRecord>> SqlJobStore::EndOverdue(const JobError& error,
                                                               int64_t now_us, int32_t limit) {
  const auto overdue = ListOverdue(*database_, now_us, limit);
  if (!overdue.ok()) return overdue.status();
  std::vector<JobRecord> ended;
  for (const std::string& id : *overdue) {
    auto job = InTransaction<std::optional<JobRecord>>(
        *database_, [&](SqlConnection& db) { return EndOverdueIn(db, id, error, now_us); });
    if (absl::IsDataLoss(job.status())) continue;  // the next claim of the job reports the damage
    if (!job.ok() && ended.empty()) return job.status();
    if (!job.ok()) break;
    if (*job) ended.push_back(**std::move(job));
  }
  return ended;
}

absl::StatusOr<bool> SqlJobStore::Adopt(const Lease& lease, const JobIdentity& identity,
                                        int64_t now_us) {
  return InTransaction<bool>(*database_, [&](SqlConnection& db) -> absl::StatusOr<bool> {
    const auto others = OthersHold(db, identity.action_digest, lease.job_id, now_us);
    if (!others.ok()) return others;
    SqlQuery adopt(
        db,
        "UPDATE jobs SET settings_digest = ?, action_digest = ?, build_id = ?, lost_runs = 0,"
        " deadly_runs = 0 WHERE id = ? AND owner_epoch = ? AND owner <> '' RETURNING id");
    adopt.Bind(identity.settings_digest, identity.action_digest, identity.build_id, lease.job_id,
               lease.epoch);
    bool held = false;
    while (adopt.Next()) held = true;
    if (!adopt.status().ok()) return adopt.status();
    if (!held) return NotHeld(lease);
    return !*others;
  });
}

absl::StatusOr<std::vector<HeldJob>> SqlJobStore::Renew(const std::vector<Lease>& leases,
                                                        int64_t until_us) {
  if (leases.empty()) return std::vector<HeldJob>();
  return InTransaction<std::vector<HeldJob>>(
      *database_, [&](SqlConnection& db) { return RenewLeases(db, leases, until_us); });
}

absl::Status SqlJobStore::Release(const std::string& owner) {
  return RunOne(*database_,
                "UPDATE jobs SET owner = '', owner_until_us = 0 WHERE owner = ? AND owner <> ''",
                owner);
}

absl::StatusOr<JobRecord> SqlJobStore::Update(const Lease& lease, const JobUpdate& update,
                                              int64_t now_us) {
  return InTransaction<JobRecord>(*database_, [&](SqlConnection& db) -> absl::StatusOr<JobRecord> {
    auto job = LockJob(db, lease.job_id);
    if (!job.ok()) return job.status();
    if (absl::Status done = ApplyUpdate(*job, lease, update, now_us); !done.ok()) return done;
    if (job->result) {
      if (absl::Status done = IndexResult(db, *job); !done.ok()) return done;
    }
    if (absl::Status done = WriteStep(db, *job, now_us); !done.ok()) return done;
    return job;
  });
}

absl::StatusOr<JobRecord> SqlJobStore::RequestCancel(const std::string& id, int64_t now_us) {
  return InTransaction<JobRecord>(*database_, [&](SqlConnection& db) -> absl::StatusOr<JobRecord> {
    auto job = LockJob(db, id);
    if (!job.ok() || !ApplyCancel(*job, now_us)) return job;
    if (absl::Status done = WriteStep(db, *job, now_us); !done.ok()) return done;
    return job;
  });
}

absl::StatusOr<JobRecord> SqlJobStore::Change(const std::string& id, const JobChanging& changing,
                                              int64_t now_us) {
  return InTransaction<JobRecord>(*database_, [&](SqlConnection& db) -> absl::StatusOr<JobRecord> {
    auto job = LockJob(db, id);
    if (!job.ok()) return job;
    ApplyChange(*job, changing);
    SqlQuery update(db,
                    "UPDATE jobs SET priority = ?, deadline_us = ?, labels = ? WHERE number = ?");
    update.Bind(static_cast<int64_t>(job->priority), job->deadline_us, ToJson(job->labels),
                job->number);
    if (absl::Status done = update.Run(); !done.ok()) return done;
    if (changing.labels) {
      SqlQuery clear(db, "DELETE FROM labels WHERE job = ?");
      if (absl::Status done = clear.Bind(job->number).Run(); !done.ok()) return done;
      if (absl::Status done = InsertLabels(db, job->number, job->labels); !done.ok()) return done;
    }
    if (absl::Status done = WriteStep(db, *job, now_us); !done.ok()) return done;
    return job;
  });
}

absl::Status SqlJobStore::Delete(const std::string& id) {
  return InTransaction<bool>(*database_,
                             [&](SqlConnection& db) -> absl::StatusOr<bool> {
                               if (absl::Status done = DeleteIn(db, id); !done.ok()) return done;
                               return true;
                             })
      .status();
}

absl::StatusOr<std::vector<JobRecord>> SqlJobStore::FindRequested(
    const std::string& tenant, const std::vector<std::string>& request_ids,
    const std::string& spec_digest) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  std::vector<JobRecord> found;
  for (const std::string& request_id : request_ids) {
    auto earlier = FindEarlier(**session, {tenant, request_id, spec_digest});
    if (!earlier.ok()) return earlier.status();
    if (*earlier) found.push_back(**std::move(earlier));
  }
  return found;
}

absl::StatusOr<JobRecord> SqlJobStore::GetWithoutSpec(const std::string& id) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return FindJobWithoutSpec(**session, id);
}

absl::StatusOr<std::vector<JobEventRecord>> SqlJobStore::Events(const std::string& id,
                                                                int64_t after, int32_t limit) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return ListEvents(**session, id, after, limit);
}

absl::StatusOr<std::vector<TenantEvent>> SqlJobStore::EventsOf(const std::string& tenant,
                                                               const EventCursor& after,
                                                               int32_t limit) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return ListEventsOf(**session, tenant, after, limit);
}

absl::StatusOr<std::optional<JobResult>> SqlJobStore::FindResult(const std::string& action_digest) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session, "SELECT result FROM results WHERE action_digest = ?");
  query.Bind(action_digest);
  if (!query.Next()) {
    if (!query.status().ok()) return query.status();
    return std::nullopt;
  }
  JobResult result;
  if (absl::Status read = FromJson(query.Text(0), result); !read.ok()) return read;
  return result;
}

absl::Status SqlJobStore::ForgetResult(const std::string& action_digest) {
  return RunOne(*database_, "DELETE FROM results WHERE action_digest = ?", action_digest);
}

absl::Status SqlJobStore::ExpireRequestIds(int64_t now_us) {
  return RunOne(*database_, "DELETE FROM requests WHERE create_us < ?", now_us - kRequestIdKeptUs);
}

absl::StatusOr<std::map<JobState, int64_t>> SqlJobStore::CountEnded() {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT state, count(*) FROM jobs"
                 " WHERE state IN ('SUCCEEDED', 'FAILED', 'CANCELLED') GROUP BY state");
  return ReadCounts(query);
}

absl::StatusOr<std::map<JobState, int64_t>> SqlJobStore::CountOpenOf(const std::string& tenant) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  const std::string sql =
      absl::StrCat("SELECT state, count(*) FROM jobs", (*session)->dialect().Through("jobs_open"),
                   " WHERE tenant = ? AND " SLICEFARM_OPEN " GROUP BY state");
  SqlQuery query(**session, sql);
  return ReadCounts(query.Bind(tenant));
}

absl::StatusOr<int64_t> SqlJobStore::CountOf(const std::string& tenant) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session, "SELECT count(*) FROM jobs WHERE tenant = ?");
  if (!query.Bind(tenant).Next()) return query.status();
  return query.Int(0);
}

absl::StatusOr<std::vector<OpenJobs>> SqlJobStore::CountOpen() {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT state, priority, count(*), min(create_us) FROM jobs WHERE " SLICEFARM_OPEN
                 " GROUP BY state, priority ORDER BY state, priority");
  std::vector<OpenJobs> open;
  while (query.Next()) {
    if (const auto state = JobStateFromName(query.Text(0))) {
      open.push_back({*state, static_cast<Priority>(query.Int(1)), query.Int(2), query.Int(3)});
    }
  }
  if (!query.status().ok()) return query.status();
  return open;
}

absl::StatusOr<std::set<std::string>> SqlJobStore::Referenced(
    const std::string& tenant, const std::set<std::string>& digests) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  const std::string sql = absl::StrCat(OfDigests(**session, kIsArtifact),
                                       " OR EXISTS (SELECT 1 FROM inputs JOIN jobs ON number = job"
                                       "  WHERE digest = value AND tenant = ?)");
  SqlQuery query(**session, sql);
  return ReadDigests(query.Bind(nlohmann::json(digests).dump(), tenant, tenant, tenant, tenant));
}

absl::StatusOr<std::set<std::string>> SqlJobStore::Artifacts(const std::string& tenant,
                                                             const std::set<std::string>& digests) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  const std::string sql = OfDigests(**session, kIsArtifact);
  SqlQuery query(**session, sql);
  return ReadDigests(query.Bind(nlohmann::json(digests).dump(), tenant, tenant, tenant));
}

absl::StatusOr<std::vector<std::string>> SqlJobStore::EndedBefore(int64_t time_us, int32_t limit) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT id FROM jobs WHERE end_us > 0 AND end_us < ?"
                 " AND NOT EXISTS (SELECT 1 FROM webhooks WHERE job = number AND state = 'DUE')"
                 " ORDER BY end_us LIMIT ?");
  query.Bind(time_us, limit);
  std::vector<std::string> ids;
  while (query.Next()) ids.push_back(query.Text(0));
  if (!query.status().ok()) return query.status();
  return ids;
}

absl::StatusOr<bool> SqlJobStore::TakeChore(const std::string& chore, int64_t now_us,
                                            int64_t until_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  return coordinator::TakeChore(**session, chore, now_us, until_us);
}

absl::StatusOr<int64_t> SqlJobStore::InUseSince(int64_t now_us, int64_t most_gap_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  return coordinator::InUseSince(**session, now_us, most_gap_us);
}

absl::StatusOr<std::unique_ptr<JobStore>> OpenSqliteJobStore(const std::string& path) {
  auto database = SqliteDatabase::Open(path);
  if (!database.ok()) return database.status();
  return std::make_unique<SqlJobStore>(*std::move(database));
}

}  // namespace slicefarm::coordinator
