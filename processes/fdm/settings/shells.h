#pragma once

#include "common/config/setting_values.h"
#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

/// Sets the number of solid layers below top surfaces and above bottom surfaces. The number is
/// top_solid_layers (bottom_solid_layers). Layers are added until the actual layer heights reach
/// top_solid_min_thickness (bottom_solid_min_thickness). The options store the largest number of
/// layers, and how many of them can be omitted if the remaining layers are thick enough
/// (ShellExtra).
void DeriveShells(const SettingValues& draft, JobRows& settings);

/// Returns the number of solid layers at the bottom of a hollow object. REQUIRES: DeriveShells was
/// called.
int32_t BottomLayers(const JobRows& settings);

}  // namespace slicefarm::config::fdm
