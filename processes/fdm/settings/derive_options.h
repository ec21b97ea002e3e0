#pragma once

#include <cstddef>
#include <span>

#include "absl/status/status.h"
#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// Returns the index of the tool that prints, counted from 0. It is the last `extruder` in `given`;
/// 0 means that the setting selects no tool.
size_t ToolOf(std::span<const Setting> given);

/// Sets the options of stages that depend on several settings: shrinkage compensation, adhesion,
/// space for the head, halos of fields. Errors: SETTING_OUT_OF_RANGE for settings that contradict
/// each other, as in Resolve.
absl::Status DeriveOptions(const OptionSources& sources);

/// Copies the settings that the G-code of each layer refers to into the options of the motion
/// stage. A layer then depends on no other settings of the job. Templates with errors are left out
/// if LeaveOutTemplate allows it. Errors: any error in the job's G-code templates;
/// REQUEST_TOO_LARGE.
absl::Status DeriveGcode(const SettingValues& draft, ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
