#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// One revision of a tenant's profile. It never changes.
struct ProfileRecord {
  std::string name;
  int64_t revision = 0;       ///< counts from 1
  std::string settings = {};  ///< opaque to the store
  std::string settings_digest = {};
  int64_t create_us = 0;

  friend bool operator==(const ProfileRecord&, const ProfileRecord&) = default;
};

struct NewProfile {
  std::string tenant;
  std::string name;
  std::string settings;
  std::string settings_digest;  ///< equal for equal settings
};

/// Settings under a name. A revision that was deleted leaves its number behind, which is given to
/// none that comes later. Whatever a call acknowledged is on disk. Thread-safe; several
/// coordinators may share one store. Errors of all: STORE_FAILED; DISK_FULL.
class ProfileStore {
 public:
  virtual ~ProfileStore() = default;

  /// Adds a revision, unless the newest one has the same settings: then that is returned.
  virtual absl::StatusOr<ProfileRecord> Put(const NewProfile& profile, int64_t now_us) = 0;

  /// `revision` 0: the newest. Errors: PROFILE_NOT_FOUND.
  virtual absl::StatusOr<ProfileRecord> Get(const std::string& tenant, const std::string& name,
                                            int64_t revision) = 0;

  /// The newest revisions by name, those after `after`, at most `limit`; without settings.
  virtual absl::StatusOr<std::vector<ProfileRecord>> List(const std::string& tenant,
                                                          const std::string& after,
                                                          int32_t limit) = 0;

  /// `revision` 0: all of them. Errors: PROFILE_NOT_FOUND.
  virtual absl::Status Delete(const std::string& tenant, const std::string& name, int64_t revision,
                              int64_t now_us) = 0;

  /// Removes revisions that kKeptRevisions newer ones followed before `before_us`, and what is left
  /// of profiles that were deleted before. Returns how many.
  virtual absl::StatusOr<int64_t> Expire(int64_t before_us) = 0;

  static constexpr int64_t kKeptRevisions = 10;
};

}  // namespace slicefarm::coordinator
