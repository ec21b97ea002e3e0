#include "services/coordinator/store/jobs/job_creation.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/jobs/job_rows.h"
#include "services/coordinator/store/jobs/job_steps.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"

namespace slicefarm::coordinator {
namespace {

/// False: another call with the same request id was faster.
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

/// Whether the tenant has so many jobs that have not ended.
absl::StatusOr<bool> HasOpen(SqlConnection& db, const std::string& tenant, int64_t count) {
  const std::string sql = absl::StrCat("SELECT 1 FROM jobs", db.dialect().Through("jobs_open"),
                                       " WHERE tenant = ? AND " SLICEFARM_OPEN " LIMIT 1 OFFSET ?");
  SqlQuery query(db, sql);
  const bool has = query.Bind(tenant, count - 1).Next();
  if (!query.status().ok()) return query.status();
  return has;
}

/// More jobs than all coordinators are about to make at a time. Who has room for so many needs no
/// lock to be counted.
constexpr int64_t kManyJobs = 2'500;

/// Jobs of a tenant that is near its bound are made one after the other: calls that count at the
/// same time do not see what the others make.
absl::Status CheckQueue(SqlConnection& db, const NewJob& job) {
  if (job.max_open == INT64_MAX) return absl::OkStatus();
  if (const std::string_view lock = db.dialect().lock_tenant; !lock.empty()) {
    const int64_t near = job.max_open - kManyJobs;
    const auto close = near > 0 ? HasOpen(db, job.tenant, near) : true;
    if (!close.ok()) return close.status();
    SqlQuery locked(db, lock);
    if (*close) locked.Bind(job.tenant).Next();
    if (!locked.status().ok()) return locked.status();
  }
  const auto full = HasOpen(db, job.tenant, job.max_open);
  if (!full.ok()) return full.status();
  return *full ? QueueFull(job.max_open) : absl::OkStatus();
}

absl::Status InsertJob(SqlConnection& db, const NewJob& job, int64_t now_us) {
  SqlQuery insert(db,
                  "INSERT INTO jobs (id, tenant, state, priority, deadline_us, spec, labels,"
                  " settings_digest, action_digest, build_id, traceparent, create_us)"
                  " VALUES (?, ?, 'QUEUED', ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.Bind(job.id, job.tenant, static_cast<int64_t>(job.priority), job.deadline_us,
              Blob{job.spec}, ToJson(job.labels), job.settings_digest, job.action_digest,
              job.build_id, job.traceparent, now_us);
  return insert.Run();
}

/// What is looked up by its value.
absl::Status InsertLists(SqlConnection& db, int64_t number, const NewJob& job) {
  for (const auto& [key, value] : job.labels) {
    SqlQuery label(db, "INSERT INTO labels (job, key, value) VALUES (?, ?, ?)");
    if (absl::Status done = label.Bind(number, key, value).Run(); !done.ok()) return done;
  }
  for (const std::string& digest : job.inputs) {
    SqlQuery input(db, "INSERT INTO inputs (job, digest) VALUES (?, ?) ON CONFLICT DO NOTHING");
    if (absl::Status done = input.Bind(number, digest).Run(); !done.ok()) return done;
  }
  return absl::OkStatus();
}

}  // namespace

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
  if (absl::IsNotFound(found.status())) return std::nullopt;  // deleted since
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
  if (absl::Status done = InsertJob(db, job, now_us); !done.ok()) return done;
  auto record = FindJob(db, job.id);
  if (!record.ok()) return record.status();
  if (absl::Status done = InsertLists(db, record->number, job); !done.ok()) return done;
  if (absl::Status done = InsertWebhook(db, record->number, job.webhook_url); !done.ok())
    return done;
  if (absl::Status done = WriteStep(db, *record, now_us); !done.ok()) return done;
  return Created{*std::move(record), /*fresh=*/true};
}

}  // namespace slicefarm::coordinator
