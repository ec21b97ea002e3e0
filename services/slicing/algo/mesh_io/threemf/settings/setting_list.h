#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/model/setting.h"

namespace slicefarm::slicing::threemf {

/// Returns true if the value of this setting names scripts that a slicer would run. The readers
/// drop such settings.
bool NamesScripts(std::string_view key);

/// Adds a setting of a file; `value` is text in config.ini format. Errors (without a location):
/// MESH_TOO_LARGE beyond limits::kMaxSettings or kMaxSettingBytes; MESH_MALFORMED without a key.
absl::Status AddSetting(std::string_view key, std::string_view value,
                        std::vector<Setting>& settings);

}  // namespace slicefarm::slicing::threemf
