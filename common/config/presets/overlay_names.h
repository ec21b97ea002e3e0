#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slicefarm::config::presets {

/// Returns the name of the profile that is the overlay of a printer preset, or of a printer preset
/// with a filament preset: `overlay.PRINTER` or `overlay.PRINTER__with__FILAMENT`. A space becomes
/// `_`. Any other character that a profile's name may not have, `_`, and a space after a space
/// become `__` and two hex digits. So different presets have different names.
std::string OverlayName(std::string_view printer, std::string_view filament = "");

/// Returns the names of all overlays of a job with these presets. Later ones override earlier ones.
std::vector<std::string> OverlayNames(std::string_view printer, std::string_view filament);

}  // namespace slicefarm::config::presets
