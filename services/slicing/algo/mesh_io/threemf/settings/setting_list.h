#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/model/setting.h"

namespace slicefarm::slicing::threemf {

/// Whether the key names scripts that a slicer would start: those are never read in.
bool NamesScripts(std::string_view key);

/// Adds a setting of a file's; its value is text as a config.ini has it. Errors (without a place):
/// MESH_TOO_LARGE beyond limits::kMaxSettings or kMaxSettingBytes, MESH_MALFORMED without a key.
absl::Status AddSetting(std::string_view key, std::string_view value,
                        std::vector<Setting>& settings);

}  // namespace slicefarm::slicing::threemf
