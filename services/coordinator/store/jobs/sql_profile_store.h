#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/profile_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// ProfileStore in an SQL database with the tables of `sqlite_schema` or `deploy/postgres`. A
/// deleted revision leaves a row without a digest; its creation time is the time of the deletion.
class SqlProfileStore : public ProfileStore {
 public:
  explicit SqlProfileStore(std::shared_ptr<SqlDatabase> database)
      : database_(std::move(database)) {}

  absl::StatusOr<ProfileRecord> Put(const NewProfile& profile, int64_t now_us) override;
  absl::StatusOr<ProfileRecord> Get(const std::string& tenant, const std::string& name,
                                    int64_t revision) override;
  absl::StatusOr<std::vector<ProfileRecord>> List(const std::string& tenant,
                                                  const std::string& after, int32_t limit) override;
  absl::Status Delete(const std::string& tenant, const std::string& name, int64_t revision,
                      int64_t now_us) override;
  absl::StatusOr<int64_t> Expire(int64_t before_us) override;

 private:
  const std::shared_ptr<SqlDatabase> database_;
};

}  // namespace slicefarm::coordinator
