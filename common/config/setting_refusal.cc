#include "common/config/setting_refusal.h"

#include <fmt/core.h>

#include <map>
#include <string>

#include "common/base/error.h"
#include "common/config/table/value.h"

namespace slicefarm::config {

absl::Status Refuse(const SettingValues& draft, std::string_view key, std::string_view rule,
                    double min, double max) {
  std::map<std::string, std::string> metadata = {{"setting", std::string(key)},
                                                 {"value", PrintNumber(draft.Number(key))}};
  if (min > 0) metadata["min"] = PrintNumber(min);
  if (max < kUnbounded) metadata["max"] = PrintNumber(max);
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
      fmt::format("{} = {} mm is out of range: {}", key, PrintNumber(draft.Number(key)), rule),
      std::move(metadata));
}

}  // namespace slicefarm::config
