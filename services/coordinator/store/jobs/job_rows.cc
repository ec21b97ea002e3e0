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

/// Columns of a row, one after the other.
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

}  // namespace

absl::Status ReadJob(const SqlQuery& query, JobRecord& job) {
  Columns columns(query);
  columns.ReadAll(job.number, job.id, job.tenant, job.state, job.priority, job.deadline_us,
                  job.spec, job.labels, job.settings_digest, job.action_digest, job.build_id,
                  job.traceparent, job.create_us, job.start_us, job.end_us, job.layers_total,
                  job.layers_done, job.error, job.result, job.cancel_requested, job.retries,
                  job.store_failures, job.lost_runs, job.last_sequence, job.trace_sha256, job.owner,
                  job.owner_epoch, job.owner_until_us);
  return columns.status(job.id);
}

absl::StatusOr<JobRecord> FindJob(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, SLICEFARM_JOB_COLUMNS, "");
}

absl::StatusOr<JobRecord> FindJobWithoutSpec(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, SLICEFARM_JOB_COLUMNS_WITH("''"), "");
}

absl::StatusOr<JobRecord> LockJob(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, SLICEFARM_JOB_COLUMNS, db.dialect().for_update);
}

absl::StatusOr<JobRecord> LockFreeJob(SqlConnection& db, const std::string& id) {
  return SelectJob(db, id, SLICEFARM_JOB_COLUMNS, db.dialect().skip_locked);
}

absl::Status WriteStep(SqlConnection& db, JobRecord& job, int64_t now_us) {
  ++job.last_sequence;
  SqlQuery update(db,
                  "UPDATE jobs SET state = ?, start_us = ?, end_us = ?, layers_total = ?,"
                  " layers_done = ?, error = ?, result = ?, gcode_sha256 = ?,"
                  " report_sha256 = ?, result_tenant = ?, cancel_requested = ?, retries = ?,"
                  " store_failures = ?, lost_runs = ?, last_sequence = ?, trace_sha256 = ?, owner "
                  "= ?, owner_epoch = ?,"
                  " owner_until_us = ? WHERE number = ?");
  update.Bind(JobStateName(job.state), job.start_us, job.end_us, job.layers_total, job.layers_done,
              job.error ? ToJson(*job.error) : "", job.result ? ToJson(*job.result) : "",
              job.result ? job.result->gcode_sha256 : "",
              job.result ? job.result->report_sha256 : "", job.result ? job.result->tenant : "",
              job.cancel_requested, job.retries, job.store_failures, job.lost_runs,
              job.last_sequence, job.trace_sha256, job.owner, job.owner_epoch, job.owner_until_us,
              job.number);
  if (absl::Status done = update.Run(); !done.ok()) return done;

  if (IsTerminal(job.state)) {
    if (absl::Status done = MakeWebhookDue(db, job.number, now_us); !done.ok()) return done;
  }
  SqlQuery event(db,
                 "INSERT INTO events (job, sequence, time_us, state, layers_total, layers_done)"
                 " VALUES (?, ?, ?, ?, ?, ?)");
  event.Bind(job.number, job.last_sequence, now_us, JobStateName(job.state), job.layers_total,
             job.layers_done);
  if (absl::Status done = event.Run(); !done.ok() || db.dialect().notify.empty()) return done;
  const JobChange change = {job.id, job.state, job.cancel_requested};
  return SqlQuery(db, db.dialect().notify).Bind(ToText(change)).Run();
}

}  // namespace slicefarm::coordinator
