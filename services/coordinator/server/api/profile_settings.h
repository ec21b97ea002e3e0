#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/jobs.pb.h"
#include "slicefarm/v1/profiles.pb.h"

namespace slicefarm::coordinator {

/// `NAME` or `NAME@REVISION`.
struct ProfileRef {
  std::string name;
  int64_t revision = 0;  ///< 0: the newest

  friend bool operator==(const ProfileRef&, const ProfileRef&) = default;
};

/// Errors: REQUEST_MALFORMED.
absl::StatusOr<ProfileRef> ParseProfileRef(const std::string& text);

/// Letters, digits, `-`, `_`, `.`; not empty; at most limits::kMaxNameBytes. Errors:
/// REQUEST_MALFORMED.
absl::Status CheckProfileName(const std::string& name);

/// The spec with the settings of its profiles before its own, and its profiles by revision: it does
/// not change when they do. Errors: REQUEST_MALFORMED; PROFILE_NOT_FOUND (FailedPrecondition);
/// those of the store.
absl::StatusOr<v1::JobSpec> WithProfiles(v1::JobSpec spec, const std::string& tenant,
                                         ProfileStore& profiles);

/// WithProfiles, and where the job then names no printer and does not say that it needs none
/// (JobSpec.generic), with `default_profile` as its first profile; empty: there is none.
absl::StatusOr<v1::JobSpec> WithMachine(const v1::JobSpec& spec, const std::string& tenant,
                                        const std::string& default_profile, ProfileStore& profiles);

/// What ProfileRecord.settings holds, and back.
std::string ProfileBytes(const google::protobuf::RepeatedPtrField<v1::Setting>& settings);
absl::StatusOr<v1::Profile> ReadProfile(const ProfileRecord& record);

}  // namespace slicefarm::coordinator
