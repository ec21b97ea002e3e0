#include "services/coordinator/store/jobs/job_rows.h"

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/store/jobs/job_changes.h"
#include "services/coordinator/store/jobs/job_steps.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"

namespace slicefarm::coordinator {
namespace {

/// Reads the columns of a row one after another.
class Columns {
 public:
  explicit Columns(const SqlQuery& query) : query_(query) {}

  void Read(int64_t& value) { value = query_.Int(next_++); }
  void Read(int32_t& value) { value = static_cast<int32_t>(query_.Int(next_++)); }
  void Read(bool& value) { value = query_.Int(next_++) != 0; }
  void Read(std::string& value) { value = query_.Text(next_++); }
  void Read(Priority& value) { value = static_cast<Priority>(query_.Int(next_++)); }
  void Read(JobState& value) {
    const auto state = JobStateFromName(query_.Text(next_++));
    if (state) value = *state;
    known_ = known_ && state;
  }
  void Read(std::map<std::string, std::string>& value) { ReadJson(value); }
  template <typename T>
  void Read(std::optional<T>& value) {
    if (query_.Text(next_).empty()) {
      ++next_;
    } else {
      ReadJson(value.emplace());
    }
  }

  template <typename... Values>
  void ReadAll(Values&... values) {
    (Read(values), ...);
  }

  absl::Status status(const std::string& job_id) const {
    if (known_) return status_;
    return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                     absl::StrCat("job ", job_id, " has no state that is known"));
  }

 private:
  template <typename T>
  void ReadJson(T& value) {
    status_.Update(FromJson(query_.Text(next_++), value));
  }

  const SqlQuery& query_;
  int next_ = 0;
  bool known_ = true;
  absl::Status status_;
};

absl::StatusOr<JobRecord> SelectJob(SqlConnection& db, const std::string& id,
                                    std::string_view columns, std::string_view locking) {
  SqlQuery query(db, absl::StrCat("SELECT ", std::string(columns), " FROM jobs WHERE id = ?",
                                  std::string(locking)));
  query.Bind(id);
  if (!query.Next()) return query.status().ok() ? JobNotFound(id) : query.status();
  JobRecord job;
  if (absl::Status read = ReadJob(query, job); !read.ok()) return read;
  return job;
}

constexpr std::string_view kStep =
    "UPDATE jobs SET state = ?, start_us = ?, end_us = ?, layers_total = ?, layers_done = ?,"
    " error = ?, result = ?, gcode_sha256 = ?, report_sha256 = ?, result_tenant = ?,"
    " cancel_requested = ?, retries = ?, store_failures = ?, lost_runs = ?, deadly_runs = ?,"
    " last_sequence = ?, trace_sha256 = ?, owner = ?, owner_epoch = ?, owner_until_us = ? WHERE "
    "number = ?";

void BindStep(SqlQuery& update, const JobRecord& job) {
  update.Bind(JobStateName(job.state), job.start_us, job.end_us, job.layers_total, job.layers_done,
              job.error ? ToJson(*job.error) : "", job.result ? ToJson(*job.result) : "",
              job.result ? job.result->gcode_sha256 : "",
              job.result ? job.result->report_sha256 : "", job.result ? job.result->tenant : "",
              job.cancel_requested, job.retries, job.store_failures, job.lost_runs, job.deadly_runs,
              job.last_sequence, job.trace_sha256, job.owner, job.owner_epoch, job.owner_until_us,
              job.number);
}

constexpr std::string_view kEvent =
    "INSERT INTO events (job, sequence, time_us, state, layers_total, layers_done)";

std::string ChangeOf(const JobRecord& job) {
  return ToText(JobChange{job.id, job.state, job.cancel_requested});
}

/// Writes the job, its webhook and its event in one statement, with one round trip to the server.
absl::Status WriteStepAtOnce(SqlConnection& db, const JobRecord& job, int64_t now_us) {
  SqlQuery step(db, absl::StrCat("WITH step AS (", std::string(kStep),
                                 " RETURNING number), due AS (UPDATE webhooks SET state = 'DUE',"
                                 " due_us = ? FROM step WHERE job = number AND ? = 1) ",
                                 std::string(kEvent),
                                 " SELECT number, CAST(? AS BIGINT), CAST(? AS BIGINT), ?,"
                                 " CAST(? AS BIGINT), CAST(? AS BIGINT) FROM step"
                                 " RETURNING pg_notify('slicefarm_jobs', ?)"));
  BindStep(step, job);
  step.Bind(now_us, IsTerminal(job.state), job.last_sequence, now_us, JobStateName(job.state),
            job.layers_total, job.layers_done, ChangeOf(job));
  return step.Run();
}

}  // namespace

std::string JobColumns(std::string_view spec) {
  return absl::StrCat(
      "number, id, tenant, state, priority, deadline_us, ", std::string(spec),
      ", labels, settings_digest, action_digest, build_id, traceparent, create_us, start_us,"
      " end_us, layers_total, layers_done, error, result, cancel_requested, retries,"
      " store_failures, lost_runs, deadly_runs, last_sequence, trace_sha256, owner, owner_epoch,"
      " owner_until_us");
}

absl::Status ReadJob(const SqlQuery& query, JobRecord& job) {
  Columns columns(query);
  columns.ReadAll(job.number, job.id, job.tenant, job.state, job.priority, job.deadline_us,
                  job.spec, job.labels, job.settings_digest, job.action_digest, job.build_id,
                  job.traceparent, job.create_us, job.start_us, job.end_us, job.layers_total,
                  job.layers_done, job.error, job.result, job.cancel_requested, job.retries,
                  job.store_failures, job.lost_runs, job.deadly_runs, job.last_sequence,
                  job.trace_sha256, job.owner, job.owner_epoch, job.owner_until_us);
  return columns.status(job.id);
}

absl::StatusOr<JobRecord> FindJob(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, JobColumns(db.dialect()), "");
}

absl::StatusOr<JobRecord> FindJobWithoutSpec(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, JobColumns("''"), "");
}

absl::StatusOr<JobRecord> LockJob(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, JobColumns("''"), db.dialect().for_update);
}

absl::StatusOr<JobRecord> LockFreeJob(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, JobColumns("''"), db.dialect().skip_locked);
}

absl::Status AppendEvent(SqlConnection& db, const JobRecord& job, int64_t now_us) {
  const bool tells = !db.dialect().notify.empty();
  SqlQuery event(db, absl::StrCat(std::string(kEvent), " VALUES (?, ?, ?, ?, ?, ?)",
                                  tells ? " RETURNING pg_notify('slicefarm_jobs', ?)" : ""));
  event.Bind(job.number, job.last_sequence, now_us, JobStateName(job.state), job.layers_total,
             job.layers_done);
  if (tells) event.Bind(ChangeOf(job));
  return event.Run();
}

absl::Status WriteStep(SqlConnection& db, JobRecord& job, int64_t now_us) {
  ++job.last_sequence;
  if (db.dialect().writes_in_with) return WriteStepAtOnce(db, job, now_us);
  SqlQuery update(db, kStep);
  BindStep(update, job);
  if (absl::Status done = update.Run(); !done.ok()) return done;
  if (IsTerminal(job.state)) {
    if (absl::Status done = MakeWebhookDue(db, job.number, now_us); !done.ok()) return done;
  }
  return AppendEvent(db, job, now_us);
}

}  // namespace slicefarm::coordinator
