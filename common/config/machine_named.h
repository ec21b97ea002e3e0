#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/model/process.h"
#include "common/model/setting.h"

namespace slicefarm::config {

/// Returns PRINTER_MISSING (metadata `settings`: keys that are not set) unless the settings of a
/// job name its machine: they set each of ProcessSettings::MachineKeys, to any value.
absl::Status CheckMachineNamed(std::span<const Setting> given, Process process);

}  // namespace slicefarm::config
