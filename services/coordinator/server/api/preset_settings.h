#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/server/api/preset_library.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns the spec as it is stored: with all settings of its presets, of its profiles and its own,
/// in this order. Presets get their full names, and bundles and profiles get revisions, so later
/// changes of them do not change the spec. The overlays of the presets that are stored as profiles
/// are inserted before the spec's profiles (config::presets::WithOverlays). The spec reports the
/// sources of its settings (ReportsSources). `default_profile`: see WithMachine.
///
/// Errors: PROFILE_NOT_FOUND (FailedPrecondition); REQUEST_MALFORMED for presets in a job of
/// another process than FDM; see WithMachine, PresetLibrary::Load and
/// config::presets::ChoosePresets.
absl::StatusOr<v1::JobSpec> WithAllSettings(v1::JobSpec spec, const std::string& tenant,
                                            const std::string& default_profile,
                                            ProfileStore& profiles, PresetLibrary& library);

/// Returns true if the job reports the sources of its settings: it has presets, or the client has
/// given sources.
bool ReportsSources(const v1::JobSpec& spec);

}  // namespace slicefarm::coordinator
