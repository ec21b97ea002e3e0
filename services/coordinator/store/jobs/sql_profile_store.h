#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/limits.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Table of revisions, and its limits for each tenant.
struct RevisionTable {
  std::string_view name;  ///< name of the table
  std::string_view what;  ///< "profile", for messages
  int64_t max_revisions = 0;
  int64_t max_bytes = 0;  ///< bytes of all stored revisions; 0: no limit
};
inline constexpr RevisionTable kProfileTable = {"profiles", "profile", limits::kMaxProfileRevisions,
                                                0};
inline constexpr RevisionTable kPresetTable = {
    "presets", "bundle of presets", limits::kMaxPresetRevisions, limits::kMaxPresetStoreBytes};

/// ProfileStore in an SQL database with the tables of `sqlite_schema` or `deploy/postgres`. A
/// deleted revision leaves a row without a digest; its creation time is the time of the deletion.
/// Bundles of presets are stored like profiles, in a table of their own.
class SqlProfileStore : public ProfileStore {
 public:
  explicit SqlProfileStore(std::shared_ptr<SqlDatabase> database,
                           const RevisionTable& table = kProfileTable)
      : database_(std::move(database)), table_(table) {}

  absl::StatusOr<ProfileRecord> Put(const NewProfile& profile, int64_t now_us) override;
  absl::StatusOr<ProfileRecord> Get(const std::string& tenant, const std::string& name,
                                    int64_t revision) override;
  absl::StatusOr<std::vector<ProfileRecord>> List(const std::string& tenant,
                                                  const std::string& after, int32_t limit) override;
  absl::Status Delete(const std::string& tenant, const std::string& name, int64_t revision,
                      int64_t now_us) override;
  absl::StatusOr<int64_t> Expire(int64_t before_us) override;

 private:
  std::string Sql(std::string_view text) const;
  absl::Status NotFound(const std::string& name, int64_t revision) const;
  /// Returns the error for a revision that is based on another one than the newest (0: none).
  absl::Status NotNewest(const NewProfile& profile, int64_t newest) const;
  absl::Status CheckSpace(SqlConnection& db, const NewProfile& profile) const;
  absl::StatusOr<std::optional<ProfileRecord>> Find(SqlConnection& db, const std::string& tenant,
                                                    const std::string& name,
                                                    int64_t revision) const;
  absl::StatusOr<int64_t> LastRevision(SqlConnection& db, const std::string& tenant,
                                       const std::string& name) const;
  absl::StatusOr<ProfileRecord> Insert(SqlConnection& db, const NewProfile& profile,
                                       int64_t revision, int64_t now_us) const;
  absl::StatusOr<ProfileRecord> PutLocked(SqlConnection& db, const NewProfile& profile,
                                          int64_t now_us) const;

  const std::shared_ptr<SqlDatabase> database_;
  const RevisionTable table_;
};

}  // namespace slicefarm::coordinator
