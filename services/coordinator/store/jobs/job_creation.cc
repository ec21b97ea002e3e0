#include "services/coordinator/store/jobs/job_creation.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/jobs/job_rows.h"
#include "services/coordinator/store/jobs/job_steps.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"

namespace slicefarm::coordinator {
namespace {

/// Records the request id. Returns false if another call with the same request id was faster.
absl::StatusOr<bool> TakeRequestId(SqlConnection& db, const NewJob& job, int64_t now_us) {
  if (job.request_id.empty()) return true;
  SqlQuery take(db,
                "INSERT INTO requests (tenant, request_id, job_id, spec_digest, create_us)"
                " VALUES (?, ?, ?, ?, ?) ON CONFLICT DO NOTHING RETURNING job_id");
  take.Bind(job.tenant, job.request_id, job.id, job.spec_digest, now_us);
  bool taken = false;
  while (take.Next()) taken = true;
  if (!take.status().ok()) return take.status();
  return taken;
}

/// Returns true if the tenant has at least `count` open jobs.
absl::StatusOr<bool> HasOpen(SqlConnection& db, const std::string& tenant, int64_t count) {
  const std::string sql = absl::StrCat("SELECT 1 FROM jobs", db.dialect().Through("jobs_open"),
                                       " WHERE tenant = ? AND " SLICEFARM_OPEN " LIMIT 1 OFFSET ?");
  SqlQuery query(db, sql);
  const bool has = query.Bind(tenant, count - 1).Next();
  if (!query.status().ok()) return query.status();
  return has;
}

/// Distance from the limit of open jobs up to which a tenant's jobs are counted with a lock. A
/// tenant that is farther below its limit needs no lock: all coordinators together create fewer
/// jobs than this at the same time.
constexpr int64_t kManyJobs = 2'500;

/// Checks the limit of open jobs. Near the limit, the jobs of a tenant are created one after
/// another, because concurrent transactions do not see each other's jobs.
absl::Status CheckQueue(SqlConnection& db, const NewJob& job) {
  if (job.max_open == INT64_MAX) return absl::OkStatus();
  if (const std::string_view lock = db.dialect().lock_tenant; !lock.empty()) {
    const int64_t near = job.max_open - kManyJobs;
    const auto close = near > 0 ? HasOpen(db, job.tenant, near) : true;
    if (!close.ok() || !*close) return close.status();
    if (absl::Status locked = SqlQuery(db, lock).Bind(job.tenant).Run(); !locked.ok())
      return locked;
  }
  const auto full = HasOpen(db, job.tenant, job.max_open);
  if (!full.ok()) return full.status();
  return *full ? QueueFull(job.max_open) : absl::OkStatus();
}

/// Returns the record of a new job, without a number.
JobRecord RecordOf(const NewJob& job, int64_t now_us) {
  JobRecord record;
  record.id = job.id;
  record.tenant = job.tenant;
  record.priority = job.priority;
  record.deadline_us = job.deadline_us;
  record.spec = job.spec;
  record.labels = job.labels;
  record.settings_digest = job.settings_digest;
  record.action_digest = job.action_digest;
  record.build_id = job.build_id;
  record.traceparent = job.traceparent;
  record.create_us = now_us;
  record.last_sequence = 1;
  return record;
}

/// Inserts the job's row and sets JobRecord::number to the number of the new row.
absl::Status InsertJob(SqlConnection& db, JobRecord& job) {
  const bool apart = db.dialect().spec != "spec";
  SqlQuery insert(
      db, absl::StrCat("INSERT INTO jobs (id, tenant, state, priority, deadline_us,"
                       " labels, settings_digest, action_digest, build_id, traceparent,"
                       " create_us, last_sequence",
                       apart ? "" : ", spec", ") VALUES (?, ?, 'QUEUED', ?, ?, ?, ?, ?, ?, ?, ?, ?",
                       apart ? "" : ", ?", ") RETURNING number"));
  insert.Bind(job.id, job.tenant, static_cast<int64_t>(job.priority), job.deadline_us,
              ToJson(job.labels), job.settings_digest, job.action_digest, job.build_id,
              job.traceparent, job.create_us, job.last_sequence);
  if (!apart) insert.Bind(Blob{job.spec});
  while (insert.Next()) job.number = insert.Int(0);
  if (!insert.status().ok() || !apart) return insert.status();
  SqlQuery spec(db, "INSERT INTO specs (job, spec) VALUES (?, ?)");
  return spec.Bind(job.number, Blob{job.spec}).Run();
}

/// Inserts the lists of a job that are searched by value: labels and inputs.
absl::Status InsertLists(SqlConnection& db, int64_t number, const NewJob& job) {
  if (absl::Status done = InsertLabels(db, number, job.labels); !done.ok()) return done;
  for (const std::string& digest : job.inputs) {
    SqlQuery input(db, "INSERT INTO inputs (job, digest) VALUES (?, ?) ON CONFLICT DO NOTHING");
    if (absl::Status done = input.Bind(number, digest).Run(); !done.ok()) return done;
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status InsertLabels(SqlConnection& db, int64_t number,
                          const std::map<std::string, std::string>& labels) {
  for (const auto& [key, value] : labels) {
    SqlQuery label(db, "INSERT INTO labels (job, key, value) VALUES (?, ?, ?)");
    if (absl::Status done = label.Bind(number, key, value).Run(); !done.ok()) return done;
  }
  return absl::OkStatus();
}

absl::StatusOr<std::optional<JobRecord>> FindEarlier(SqlConnection& db, const Request& request) {
  SqlQuery query(db,
                 "SELECT job_id, spec_digest FROM requests WHERE tenant = ? AND request_id = ?");
  query.Bind(request.tenant, request.request_id);
  if (!query.Next()) {
    if (!query.status().ok()) return query.status();
    return std::nullopt;
  }
  if (query.Text(1) != request.spec_digest) return RequestIdReused(request.request_id);
  auto found = FindJob(db, query.Text(0));
  if (absl::IsNotFound(found.status())) return std::nullopt;  // deleted since then
  if (!found.ok()) return found.status();
  return *std::move(found);
}

absl::StatusOr<Created> MakeJob(SqlConnection& db, const NewJob& job, int64_t now_us) {
  const auto taken = TakeRequestId(db, job, now_us);
  if (!taken.ok()) return taken.status();
  if (!*taken) {
    auto earlier = FindEarlier(db, {job.tenant, job.request_id, job.spec_digest});
    if (!earlier.ok()) return earlier.status();
    if (*earlier) return Created{**std::move(earlier), /*fresh=*/false};
    return StoreAway("a job with the same request_id is being removed");
  }
  if (!job.refusal.ok()) return job.refusal;
  if (absl::Status ok = CheckQueue(db, job); !ok.ok()) return ok;
  JobRecord record = RecordOf(job, now_us);
  if (absl::Status done = InsertJob(db, record); !done.ok()) return done;
  if (absl::Status done = InsertLists(db, record.number, job); !done.ok()) return done;
  if (absl::Status done = InsertWebhook(db, record.number, job.webhook_url); !done.ok())
    return done;
  if (absl::Status done = AppendEvent(db, record, now_us); !done.ok()) return done;
  return Created{std::move(record), /*fresh=*/true};
}

}  // namespace slicefarm::coordinator
