#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Revision of a tenant's profile. It never changes.
struct ProfileRecord {
  std::string name;
  int64_t revision = 0;       ///< number of the revision, counted from 1
  std::string settings = {};  ///< opaque to the store
  std::string settings_digest = {};
  int64_t create_us = 0;

  friend bool operator==(const ProfileRecord&, const ProfileRecord&) = default;
};

/// Profile revision to be stored.
struct NewProfile {
  std::string tenant;
  std::string name;
  std::string settings;
  std::string settings_digest;  ///< equal settings have equal digests
  /// newest revision, on which the new one is based; 0: there is none; nullopt: no condition
  std::optional<int64_t> base = {};
};

/// Store of profiles: revisions of settings, by name. The number of a deleted revision is never
/// used again. All changes that a call has acknowledged are on disk. Thread-safe; several
/// coordinators may share one store. Errors of all functions: STORE_FAILED; DISK_FULL.
class ProfileStore {
 public:
  virtual ~ProfileStore() = default;

  /// Adds a revision. If the newest revision has the same settings, returns that revision instead.
  /// Errors: PROFILE_NOT_FOUND (Aborted, metadata `revision`) if `profile.base` is not the newest
  /// revision. The check and the change are one step, even among several coordinators.
  virtual absl::StatusOr<ProfileRecord> Put(const NewProfile& profile, int64_t now_us) = 0;

  /// Returns a revision. `revision` 0: the newest. Errors: PROFILE_NOT_FOUND.
  virtual absl::StatusOr<ProfileRecord> Get(const std::string& tenant, const std::string& name,
                                            int64_t revision) = 0;

  /// Returns the newest revision of each profile, sorted by name, with names after `after`; at most
  /// `limit`, without settings.
  virtual absl::StatusOr<std::vector<ProfileRecord>> List(const std::string& tenant,
                                                          const std::string& after,
                                                          int32_t limit) = 0;

  /// Deletes a revision. `revision` 0: all revisions of the profile. Errors: PROFILE_NOT_FOUND.
  virtual absl::Status Delete(const std::string& tenant, const std::string& name, int64_t revision,
                              int64_t now_us) = 0;

  /// Removes each revision that at the time `before_us` already had kKeptRevisions newer revisions.
  /// Also removes the rows that mark revisions deleted before this time. Returns the number of
  /// removed rows.
  virtual absl::StatusOr<int64_t> Expire(int64_t before_us) = 0;

  static constexpr int64_t kKeptRevisions = 10;
};

}  // namespace slicefarm::coordinator
