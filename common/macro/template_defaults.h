#pragma once

#include <string_view>

namespace slicefarm::macro {

/// Returns PrusaSlicer's and Bambu Studio's default values of settings that a job may lack, as
/// `key = value` lines. The G-code of profiles uses such settings ({if spiral_vase}) and expects
/// that they always have a value. Settings that stages use always have a value, and are not in this
/// list.
std::string_view TemplateDefaults();

}  // namespace slicefarm::macro
