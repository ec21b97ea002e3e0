#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/server/api/preset_library.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns the spec `given` by the client as it is stored: with all settings of its presets, of its
/// profiles and its own, in this order. Presets get their full names, and bundles and profiles get
/// revisions, so that later revisions do not change the spec. Stored overlays of the presets are
/// inserted before the profiles of the spec (config::presets::WithOverlays). If the spec has
/// presets or sources (ReportsSources), it also gets the sources of all settings.
/// `default_profile`: see WithMachine.
///
/// Errors: PROFILE_NOT_FOUND (FailedPrecondition); REQUEST_MALFORMED for presets in a job of
/// another process than FDM; see WithMachine, PresetLibrary::Load and
/// config::presets::ChoosePresets.
absl::StatusOr<v1::JobSpec> WithAllSettings(v1::JobSpec given, const std::string& tenant,
                                            const std::string& default_profile,
                                            ProfileStore& profiles, PresetLibrary& library);

/// Returns true if the job reports the sources of its settings: it has presets, or the client has
/// given sources.
bool ReportsSources(const v1::JobSpec& spec);

}  // namespace slicefarm::coordinator
