#pragma once

#include "absl/status/status.h"
#include "common/model/limits.h"
#include "common/wire/options/value_checks.h"

namespace slicefarm {

/// Returns an error unless the counts of solid layers, and of those among them that may be left out,
/// are in range. `Skins`: InfillOptions or InfillPlanOptions.
template <typename Skins>
absl::Status CheckSkins(const Skins& skins) {
  absl::Status status =
      CheckRange("top_solid_layers", skins.top_solid_layers, 0, limits::kMaxLayers);
  status.Update(CheckRange("bottom_solid_layers", skins.bottom_solid_layers, 0,
                           limits::kMaxLayers));
  for (const SkinSpare& spare : {skins.top_spare, skins.bottom_spare}) {
    status.Update(CheckRange("spare.layers", spare.layers, 0, limits::kMaxLayers));
    status.Update(CheckNotNegative({{"spare.enough_nm", spare.enough_nm}}));
  }
  return status;
}

}  // namespace slicefarm
