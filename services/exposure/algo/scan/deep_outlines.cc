#include "services/exposure/algo/scan/deep_outlines.h"

#include <algorithm>

#include "common/geometry/boolean/boolean.h"

namespace slicefarm::exposure {

MultiPolygon DeepOutlines::Of(const ObjectSection& section, MultiPolygon outlines) const {
  const MultiPolygon& whole = OutlineOf(section);
  for (int32_t i = 1; i <= std::min(depth_, section.layer) && !outlines.empty(); ++i) {
    const ObjectSection* below = objects_.Find(section.stack.id, section.layer - i);
    if (below == nullptr) return {};
    if (OutlineOf(*below) != whole) outlines = Intersection(outlines, OutlineOf(*below));
  }
  return outlines;
}

const MultiPolygon* DeepOutlines::Find(int32_t object, int32_t layer) {
  const ObjectSection* section = objects_.Find(object, layer);
  if (section == nullptr) return nullptr;
  if (depth_ == 0) return &OutlineOf(*section);
  const auto [found, is_new] = made_.try_emplace({object, layer});
  if (is_new) found->second = Of(*section, OutlineOf(*section));
  return &found->second;
}

}  // namespace slicefarm::exposure
