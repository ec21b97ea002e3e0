#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/settings/names.h"

namespace slicefarm::slicing::threemf {

bool NamesScripts(std::string_view key) { return key == "post_process"; }

absl::Status AddSetting(std::string_view key, std::string_view value,
                        std::vector<Setting>& settings) {
  Setting setting;
  setting.key = CleanName(key);
  if (setting.key.empty()) return Malformed("a setting without a name");
  if (static_cast<int64_t>(value.size()) > limits::kMaxSettingBytes)
    return LimitError(Reason::kMeshTooLarge, "bytes of the setting `" + setting.key + "`",
                      limits::kMaxSettingBytes, static_cast<int64_t>(value.size()));
  if (static_cast<int64_t>(settings.size()) >= limits::kMaxSettings)
    return LimitError(Reason::kMeshTooLarge, "settings in the file", limits::kMaxSettings,
                      limits::kMaxSettings + 1);
  setting.value = value;
  setting.source = Source::kProfile;
  settings.push_back(std::move(setting));
  return absl::OkStatus();
}

}  // namespace slicefarm::slicing::threemf
