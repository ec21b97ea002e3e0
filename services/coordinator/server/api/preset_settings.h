#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/server/api/preset_library.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns the spec with the settings of its presets before its other settings, and with the
/// sources of all settings. The presets get their full names and the revisions of their bundles, so
/// that later revisions do not change the spec. Specs without presets stay, except for sources.
///
/// `given`: the client's spec. `spec`: the same with the settings of its profiles (WithProfiles).
/// Errors: PROFILE_NOT_FOUND (FailedPrecondition); REQUEST_MALFORMED for presets in a job of
/// another process than FDM; see PresetLibrary::Load and config::presets::ChoosePresets.
absl::StatusOr<v1::JobSpec> WithPresets(const v1::JobSpec& given, v1::JobSpec spec,
                                        const std::string& tenant, PresetLibrary& library);

/// Returns true if the job tells the sources of its settings: it has presets, or the client has
/// given sources.
bool TellsSources(const v1::JobSpec& spec);

}  // namespace slicefarm::coordinator
