#pragma once

#include <memory>
#include <string>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// JobStore in an SQL database with the tables of `sqlite_schema` or `deploy/postgres`.
class SqlJobStore : public JobStore {
 public:
  explicit SqlJobStore(std::shared_ptr<SqlDatabase> database) : database_(std::move(database)) {}

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override;
  absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                 int64_t now_us) override;
  absl::StatusOr<JobRecord> Get(const std::string& id) override;
  absl::StatusOr<std::string> TenantOf(const std::string& id) override;
  absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) override;
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter) override;
  absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                    int32_t limit) override;
  absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                             int64_t now_us) override;
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override;
  absl::Status Release(const std::string& owner) override;
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override;
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override;
  absl::StatusOr<JobRecord> Change(const std::string& id, const JobChanging& changing,
                                   int64_t now_us) override;
  absl::Status Delete(const std::string& id) override;
  absl::StatusOr<std::vector<JobRecord>> FindRequested(const std::string& tenant,
                                                       const std::vector<std::string>& request_ids,
                                                       const std::string& spec_digest) override;
  absl::StatusOr<JobRecord> GetWithoutSpec(const std::string& id) override;
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override;
  absl::StatusOr<std::vector<TenantEvent>> EventsOf(const std::string& tenant,
                                                    const EventCursor& after,
                                                    int32_t limit) override;
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) override;
  absl::Status ForgetResult(const std::string& action_digest) override;
  absl::Status ExpireRequestIds(int64_t now_us) override;
  absl::StatusOr<std::map<JobState, int64_t>> CountEnded() override;
  absl::StatusOr<int64_t> CountOf(const std::string& tenant) override;
  absl::StatusOr<std::map<JobState, int64_t>> CountOpenOf(const std::string& tenant) override;
  absl::StatusOr<std::vector<OpenJobs>> CountOpen() override;
  absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) override;
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override;
  absl::StatusOr<std::set<std::string>> Artifacts(const std::string& tenant,
                                                  const std::set<std::string>& digests) override;
  absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) override;
  absl::StatusOr<int64_t> InUseSince(int64_t now_us, int64_t most_gap_us) override;
  absl::StatusOr<bool> TakeChore(const std::string& chore, int64_t now_us,
                                 int64_t until_us) override;

 private:
  const std::shared_ptr<SqlDatabase> database_;
};

/// Opens a job store in a local SQLite file (SqliteDatabase).
absl::StatusOr<std::unique_ptr<JobStore>> OpenSqliteJobStore(const std::string& path);

}  // namespace slicefarm::coordinator
