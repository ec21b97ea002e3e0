#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/revision_ref.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/jobs.pb.h"
#include "slicefarm/v1/profiles.pb.h"

namespace slicefarm::coordinator {

/// Reads a reference to a profile or a bundle, and checks its name. Errors: REQUEST_MALFORMED;
/// REQUEST_TOO_LARGE.
absl::StatusOr<RevisionRef> ParseProfileRef(const std::string& text);

/// Converts NotFound to FailedPrecondition, because the request only refers to the profile or
/// preset and does not request it.
absl::Status AsPrecondition(const absl::Status& status);

/// Checks a profile name: letters, digits, `-`, `_`, `.`; not empty; at most limits::kMaxNameBytes.
/// Errors: REQUEST_MALFORMED, REQUEST_TOO_LARGE.
absl::Status CheckProfileName(const std::string& name);

/// Returns the spec with the settings of its profiles inserted before its own settings. References
/// to profiles get revision numbers, so that later changes of the profiles do not change the spec.
/// If the job reports sources (ReportsSources), each profile becomes one.
/// Errors: REQUEST_MALFORMED; PROFILE_NOT_FOUND (FailedPrecondition); see ProfileStore.
absl::StatusOr<v1::JobSpec> WithProfiles(v1::JobSpec spec, const std::string& tenant,
                                         ProfileStore& profiles);

/// Applies WithProfiles. If the job then names no printer, has no presets and is not generic
/// (JobSpec.generic), inserts `default_profile` as its first profile; an empty `default_profile`
/// has no effect. Errors: as in WithProfiles.
absl::StatusOr<v1::JobSpec> WithMachine(const v1::JobSpec& spec, const std::string& tenant,
                                        const std::string& default_profile, ProfileStore& profiles);

/// Returns the bytes of ProfileRecord.settings.
std::string ProfileBytes(const google::protobuf::RepeatedPtrField<v1::Setting>& settings);
/// Returns the profile with the settings that the record's bytes contain. Errors: DATA_LOSS.
absl::StatusOr<v1::Profile> ReadProfile(const ProfileRecord& record);

}  // namespace slicefarm::coordinator
