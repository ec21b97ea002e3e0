#include "common/config/machine_named.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "common/base/error.h"
#include "common/config/process_settings.h"

namespace slicefarm::config {

absl::Status CheckMachineNamed(std::span<const Setting> given, Process process) {
  std::string unset;
  for (const std::string_view key : SettingsOf(process).MachineKeys()) {
    if (std::ranges::find(given, key, &Setting::key) != given.end()) continue;
    unset += fmt::format("{}{}", unset.empty() ? "" : ", ", key);
  }
  if (unset.empty()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kPrinterMissing,
                   "the settings do not name a printer; missing settings: " + unset,
                   {{"settings", unset}});
}

}  // namespace slicefarm::config
