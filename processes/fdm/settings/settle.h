#pragma once

#include <cstddef>
#include <span>

#include "absl/status/status.h"
#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// Returns the index of the tool that prints, counted from 0. It is the last `extruder` in `given`;
/// 0 means that the setting selects no tool.
size_t ToolOf(std::span<const Setting> given);

/// Sets the options of stages that depend on several settings: growth, adhesion, space for the
/// head, halos of fields. Errors: errors of Resolve about settings that contradict each other.
absl::Status Settle(const Settling& settling);

/// Adds the settings that the G-code of each layer refers to, and no other settings. Layers thus do
/// not depend on other settings. Errors: errors of the job's G-code; REQUEST_TOO_LARGE.
absl::Status TakeGcode(const Draft& draft, ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
