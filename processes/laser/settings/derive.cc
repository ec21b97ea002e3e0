#include "processes/laser/settings/derive.h"

#include "common/config/derive_steps.h"

namespace slicefarm::config::laser {

absl::Status Derive(SettingValues& draft) {
  ResolvePercentage(draft, "first_layer_height");
  RaiseTo(draft, "outline_resolution", "resolution");
  return CheckPercentages(draft);
}

}  // namespace slicefarm::config::laser
