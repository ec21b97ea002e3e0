#include "common/config/table/setting_limits.h"

#include <fmt/core.h>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::config {

absl::Status CheckSettingSize(std::string_view key, std::string_view value) {
  const auto size = static_cast<int64_t>(key.size() + value.size());
  const int64_t most = limits::MaxSettingBytes(key);
  if (size <= most) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, fmt::format("bytes of the setting {:.60}", key), most,
                    size);
}

absl::Status CheckSettingCount(int64_t count) {
  if (count <= limits::kMaxSettings) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "settings", limits::kMaxSettings, count);
}

}  // namespace slicefarm::config
