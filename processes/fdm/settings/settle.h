#pragma once

#include <cstddef>
#include <span>

#include "absl/status/status.h"
#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// The tool that prints, from 0: the last `extruder` that is given, 0 being none of its own.
size_t ToolOf(std::span<const Setting> given);

/// What options of stages take from settings that are about others: growth, adhesion, room for the
/// head, halos of fields. Errors: those of Resolve about settings that do not fit each other.
absl::Status Settle(const Settling& settling);

/// What the G-code of each layer names goes along with its options, and no more: the rest is no
/// part of what decides a layer. Errors: those of the job's G-code; REQUEST_TOO_LARGE.
absl::Status TakeGcode(const Draft& draft, ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
