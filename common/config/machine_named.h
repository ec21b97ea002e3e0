#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/model/process.h"
#include "common/model/setting.h"

namespace slicefarm::config {

/// Checks that the settings of a job name its machine: they set each of
/// ProcessSettings::MachineKeys, to any value. Errors: PRINTER_MISSING (metadata `settings`: keys
/// that are not set).
absl::Status CheckMachineNamed(std::span<const Setting> given, Process process);

}  // namespace slicefarm::config
