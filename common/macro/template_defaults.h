#pragma once

#include <string_view>

namespace slicefarm::macro {

/// PrusaSlicer's own values of settings that a job may not have been given, as `key = value` lines.
/// A profile's G-code asks for them ({if spiral_vase}) on the understanding that there is always a
/// value. Settings that stages work with always have one, and are not in this list.
std::string_view TemplateDefaults();

}  // namespace slicefarm::macro
