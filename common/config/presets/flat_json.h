#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/setting.h"

namespace slicefarm::config::presets {

/// JSON object as OrcaSlicer and Bambu Studio write presets: texts and lists of texts.
struct FlatJson {
  /// Members in the file's order. Texts have the escapes of a config.ini; lists are JSON.
  std::vector<Setting> members;
  /// Keys of members that are neither texts nor lists of texts. OrcaSlicer and Bambu Studio ignore
  /// these members.
  std::vector<std::string> ignored;
};

/// Reads a file of one JSON object. Errors: SETTING_MALFORMED, with the reason, if the text is not
/// a JSON object; REQUEST_TOO_LARGE beyond the limits of setting_limits.h. Cost: O(bytes), no
/// recursion.
absl::StatusOr<FlatJson> ReadFlatJson(std::string_view text);

}  // namespace slicefarm::config::presets
