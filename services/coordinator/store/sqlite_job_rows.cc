#include "services/coordinator/store/sqlite_job_rows.h"

#include "absl/strings/str_cat.h"
#include "common/model/error.h"
#include "services/coordinator/store/job_steps.h"

namespace slicefarm::coordinator {
namespace {

absl::Status ReadJson(const SqliteQuery& query, JobRecord& job) {
  if (absl::Status read = FromJson(query.Text(4), job.labels); !read.ok()) return read;
  if (const std::string error = query.Text(13); !error.empty()) {
    if (absl::Status read = FromJson(error, job.error.emplace()); !read.ok()) return read;
  }
  if (const std::string result = query.Text(14); !result.empty()) {
    if (absl::Status read = FromJson(result, job.result.emplace()); !read.ok()) return read;
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<JobRecord> ReadJob(const SqliteQuery& query) {
  JobRecord job;
  job.number = query.Int(0);
  job.id = query.Text(1);
  const auto state = JobStateFromName(query.Text(2));
  if (!state) {
    return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                     absl::StrCat("job ", job.id, " has no state that is known"));
  }
  job.state = *state;
  job.spec = query.Text(3);
  job.settings_digest = query.Text(5);
  job.action_digest = query.Text(6);
  job.build_id = query.Text(7);
  job.create_us = query.Int(8);
  job.start_us = query.Int(9);
  job.end_us = query.Int(10);
  job.layers_total = static_cast<int32_t>(query.Int(11));
  job.layers_done = static_cast<int32_t>(query.Int(12));
  job.cancel_requested = query.Int(15) != 0;
  job.retries = static_cast<int32_t>(query.Int(16));
  job.last_sequence = query.Int(17);
  job.owner = query.Text(18);
  job.owner_epoch = query.Int(19);
  job.owner_until_us = query.Int(20);
  job.store_failures = static_cast<int32_t>(query.Int(21));
  if (absl::Status read = ReadJson(query, job); !read.ok()) return read;
  return job;
}

absl::StatusOr<std::vector<JobRecord>> ReadJobs(SqliteQuery& query) {
  std::vector<JobRecord> jobs;
  while (query.Next()) {
    auto job = ReadJob(query);
    if (!job.ok()) return job.status();
    jobs.push_back(*std::move(job));
  }
  if (!query.status().ok()) return query.status();
  return jobs;
}

absl::StatusOr<JobRecord> FindJob(SqliteConnection& db, const std::string& id) {
  SqliteQuery query(db, "SELECT " SLICEFARM_JOB_COLUMNS " FROM jobs WHERE id = ?");
  query.Bind(id);
  if (query.Next()) return ReadJob(query);
  return query.status().ok() ? JobNotFound(id) : query.status();
}

absl::Status WriteStep(SqliteConnection& db, JobRecord& job, int64_t now_us) {
  ++job.last_sequence;
  SqliteQuery update(
      db,
      "UPDATE jobs SET state = ?, start_us = ?, end_us = ?, layers_total = ?,"
      " layers_done = ?, error = ?, result = ?, gcode_sha256 = ?,"
      " report_sha256 = ?, cancel_requested = ?, retries = ?, store_failures = ?,"
      " last_sequence = ?, owner = ?, owner_epoch = ?, owner_until_us = ? WHERE number = ?");
  update.Bind(JobStateName(job.state), job.start_us, job.end_us, job.layers_total, job.layers_done,
              job.error ? ToJson(*job.error) : "", job.result ? ToJson(*job.result) : "",
              job.result ? job.result->gcode_sha256 : "",
              job.result ? job.result->report_sha256 : "", job.cancel_requested, job.retries,
              job.store_failures, job.last_sequence, job.owner, job.owner_epoch, job.owner_until_us,
              job.number);
  if (absl::Status done = update.Run(); !done.ok()) return done;

  SqliteQuery event(db,
                    "INSERT INTO events (job, sequence, time_us, state, layers_total, layers_done)"
                    " VALUES (?, ?, ?, ?, ?, ?)");
  return event
      .Bind(job.number, job.last_sequence, now_us, JobStateName(job.state), job.layers_total,
            job.layers_done)
      .Run();
}

}  // namespace slicefarm::coordinator
