#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/placement.h"
#include "services/texture/algo/paths/boundary_margin.h"
#include "services/texture/algo/paths/engrave_options.h"
#include "services/texture/algo/paths/placement.h"
#include "services/texture/algo/paths/surface_map.h"
#include "services/texture/algo/pattern/section.h"
#include "services/texture/algo/pattern/texture.h"

namespace slicefarm::texture {

/// Data that all layers of a job share. Layers are numbered from the texture's base.
struct EngravePlan {
  SurfaceMap map;
  Texture texture;
  /// Mask over the bounding box of the map. Only the area where it is higher than half is worked.
  std::optional<Texture> mask;
  EngraveOptions options;
  Placement placement;
  std::vector<double> heights_mm;  ///< height of each layer above the texture's base

  /// Returns the number of layers.
  int32_t layer_count() const { return static_cast<int32_t>(heights_mm.size()); }
  /// Returns the layer (counted from the texture's base) that is worked at position i of the order.
  int32_t LayerAt(int32_t i) const { return options.outside ? layer_count() - 1 - i : i; }
};

/// Makes the plan of a job. Errors: SETTING_OUT_OF_RANGE with the name of the option;
/// REQUEST_TOO_LARGE for more layers than limits::kMaxLayers.
absl::StatusOr<EngravePlan> PlanEngraving(SurfaceMap map, Texture texture,
                                          std::optional<HeightGrid> mask,
                                          const EngraveOptions& options);

}  // namespace slicefarm::texture
