#include "processes/fdm/settings/object_needs.h"

#include <fmt/core.h>

#include <algorithm>

#include "processes/fdm/settings/table/needs.h"

namespace slicefarm::config::fdm {

std::vector<std::string> NeedsOfObject(const SceneObject& object, const JobRows& settings) {
  std::vector<std::string> unmet;
  const bool enforced =
      std::ranges::count(object.parts, PartRole::kSupportEnforcer, &Part::role) > 0;
  if (enforced && !needs::HasSupports(settings))
    unmet.push_back("support enforcers, painted or as parts: needs support_material = 1");
  if (settings.object.height_profile.empty()) return unmet;
  for (const HeightRange& range : object.ranges)
    for (const Setting& setting : range.settings)
      if (setting.key == "layer_height")
        unmet.push_back(fmt::format("layer_height = {} from {} to {} mm: needs {}", setting.value,
                                    range.from_mm, range.to_mm, needs::kNoHeightProfile.what));
  return unmet;
}

}  // namespace slicefarm::config::fdm
