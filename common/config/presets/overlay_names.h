#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"

namespace slicefarm::config::presets {

/// Returns the name of the profile that is the overlay of a printer preset, or of a printer preset
/// with a filament preset: `overlay.PRINTER` or `overlay.PRINTER__with__FILAMENT`. A space becomes
/// `_`. Any other character that a profile's name may not have, `_`, and a space after a space
/// become `__` and two hex digits. So different presets have different names.
std::string OverlayName(std::string_view printer, std::string_view filament = "");

/// Returns the number of the newest revision of a profile. Errors: NotFound if there is no such
/// profile.
using NewestRevision = std::function<absl::StatusOr<int64_t>(const std::string& name)>;

/// Returns the profiles of a job, each `NAME` or `NAME@REVISION`, with the overlays of its presets
/// before them: of the printer, then of the printer with the filament. Overlays that do not exist
/// or that `profiles` names are not added. Errors: any error of `newest`, except NotFound.
absl::StatusOr<std::vector<std::string>> WithOverlays(const PresetNames& presets,
                                                      std::vector<std::string> profiles,
                                                      const NewestRevision& newest);

}  // namespace slicefarm::config::presets
