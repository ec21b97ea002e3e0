#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/setting.h"

namespace slicefarm::config::presets {

/// JSON object as OrcaSlicer and Bambu Studio write presets: texts and lists of texts.
struct FlatJson {
  /// Members in their order. Texts have the escapes of a config.ini; lists are JSON.
  std::vector<Setting> members;
  /// Keys of members that are neither texts nor lists of texts. The programs ignore them.
  std::vector<std::string> ignored;
};

/// Reads a file of one JSON object. Errors: SETTING_MALFORMED for text that is no JSON object, with
/// the reason; REQUEST_TOO_LARGE beyond the limits of settings. Cost: O(n), no recursion.
absl::StatusOr<FlatJson> ReadFlatJson(std::string_view text);

}  // namespace slicefarm::config::presets
