#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "services/coordinator/store/job_store.h"
#include "services/coordinator/store/sqlite_connection.h"

namespace slicefarm::coordinator {

/// A JobStore in one file, for one machine. Writes go over one connection and reads over another,
/// so that no reader waits for a writer's fsync.
class SqliteJobStore : public JobStore {
 public:
  /// Opens or creates the database and brings it to the present schema.
  static absl::StatusOr<std::unique_ptr<SqliteJobStore>> Open(const std::string& path);

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override;
  absl::StatusOr<JobRecord> Get(const std::string& id) override;
  absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) override;
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const std::set<std::string>& busy) override;
  absl::Status Adopt(const Lease& lease, const JobIdentity& identity) override;
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override;
  absl::Status Release(const std::string& owner) override;
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override;
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override;
  absl::StatusOr<std::vector<std::string>> Delete(const std::string& id) override;
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override;
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) override;
  absl::Status ForgetResult(const std::string& action_digest) override;
  absl::Status ExpireRequestIds(int64_t now_us) override;
  absl::StatusOr<std::map<JobState, int64_t>> CountByState() override;

 private:
  SqliteJobStore(std::unique_ptr<SqliteConnection> writer, std::unique_ptr<SqliteConnection> reader)
      : writer_(std::move(writer)), reader_(std::move(reader)) {}

  std::mutex write_mutex_;
  std::unique_ptr<SqliteConnection> writer_;
  std::mutex read_mutex_;
  std::unique_ptr<SqliteConnection> reader_;
};

}  // namespace slicefarm::coordinator
