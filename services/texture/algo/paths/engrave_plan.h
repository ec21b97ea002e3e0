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

/// All that the layers of a job share. Layers are numbered from the texture's base.
struct EngravePlan {
  SurfaceMap map;
  Texture texture;
  std::optional<Texture> mask;  ///< laid over the map's box; works where it is higher than half
  EngraveOptions options;
  Placement placement;
  std::vector<double> heights_mm;  ///< by layer, above the texture's base

  int32_t layer_count() const { return static_cast<int32_t>(heights_mm.size()); }
  /// The layer that is worked as the i-th.
  int32_t LayerAt(int32_t i) const { return options.outside ? layer_count() - 1 - i : i; }
};

/// Errors: SETTING_OUT_OF_RANGE, naming the option; REQUEST_TOO_LARGE for more layers than
/// limits::kMaxLayers.
absl::StatusOr<EngravePlan> PlanEngraving(SurfaceMap map, Texture texture,
                                          std::optional<HeightGrid> mask,
                                          const EngraveOptions& options);

}  // namespace slicefarm::texture
