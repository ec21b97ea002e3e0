#pragma once

#include <string>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/layers/layer.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"
#include "processes/engrave/model/engrave_input.h"
#include "processes/engrave/model/engraved_layer.h"

namespace slicefarm {

/// Texture stage for tests. Its map is the surface seen from above. It has seven layers, each with
/// one line of text; a whole file is one line.
class FakeTexture : public TextureStage {
 public:
  static constexpr int32_t kLayers = 7;

  absl::StatusOr<MappedSurface> Map(const StageCall&,
                                    const Shared<SurfaceInput>& surface) const override {
    MappedSurface mapped{surface->mesh, {}, {}};
    for (const Eigen::Vector3d& p : surface->mesh.points_mm) {
      mapped.vertex_of.push_back(static_cast<int32_t>(mapped.vertex_of.size()));
      mapped.map_mm.push_back({p.x(), p.y()});
    }
    return mapped;
  }
  absl::StatusOr<EngraveLayout> LayOut(const StageCall&,
                                       const Shared<EngraveInput>&) const override {
    return EngraveLayout{kLayers, "head\n", "foot\n", {.faces = 1}};
  }
  absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall&,
                                                     const Shared<EngraveInput>& input,
                                                     LayerRange range) const override {
    if (IsWhole(input->settings.format)) return std::vector<EngravedLayer>{{{}, {}, "whole\n"}};
    std::vector<EngravedLayer> layers;
    for (int32_t i = range.first; i < range.last; ++i) {
      const int32_t layer = input->settings.texture.outside ? kLayers - 1 - i : i;
      layers.push_back({.numbers = {.layer = layer, .runs = 1, .on_mm = 2},
                        .program = {.seconds = 3, .moves = 1},
                        .text = "layer " + std::to_string(layer) + "\n"});
    }
    return layers;
  }
};

}  // namespace slicefarm
