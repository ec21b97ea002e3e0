#include "common/model/layers/region_check.h"

#include <fmt/core.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm {

absl::Status CheckRegion(int32_t settings, int32_t tool, size_t rows, const LayerFrame& frame) {
  const auto refuse = [&](std::string_view field, std::string_view why) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("layer {}: {}", frame.index, why),
                     {{"field", std::string(field)}, {"layer", std::to_string(frame.index)}});
  };
  if (settings < 0 || static_cast<size_t>(settings) >= rows)
    return refuse("settings", fmt::format("row {} of {} settings of regions", settings, rows));
  if (tool != 0) return refuse("tool", fmt::format("tool {}, but there is only tool 0", tool));
  return absl::OkStatus();
}

absl::Status CheckRegions(const SlicedLayer& layer, size_t rows) {
  for (const ObjectSection& section : layer.sections)
    for (const Region& region : section.regions)
      if (absl::Status ok = CheckRegion(region.settings, region.tool, rows, layer.frame); !ok.ok())
        return ok;
  return absl::OkStatus();
}

}  // namespace slicefarm
