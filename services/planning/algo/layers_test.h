#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/model/layers/layer.h"

namespace slicefarm::planning {

/// Returns one object's section of a layer of its own, from text. Empty text means no outline.
inline ObjectSection SectionOrDie(int32_t object, int32_t layer, std::string_view outlines) {
  ObjectSection section;
  section.stack = object;
  section.layer = layer;
  section.layer_count = 1'000;
  section.height_nm = 200'000;
  if (!outlines.empty())
    section.regions.push_back({Role::kPart, 0, 0, MakePolygonsOrDie(outlines)});
  return section;
}

/// Returns the layers of one object, bottom up.
inline std::vector<SlicedLayer> LayersOrDie(const std::vector<std::string_view>& texts) {
  std::vector<SlicedLayer> layers(texts.size());
  for (size_t i = 0; i < texts.size(); ++i) {
    const auto index = static_cast<int32_t>(i);
    layers[i].frame = {index, (index + 1) * Coord{200'000}, 200'000};
    layers[i].sections = {SectionOrDie(0, index, texts[i])};
  }
  return layers;
}

}  // namespace slicefarm::planning
