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

/// Settings under a name. Whatever a call acknowledged is on disk. Thread-safe; several
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
};

}  // namespace slicefarm::coordinator
