#include "services/motion/algo/toolpath/layer_place.h"

#include <algorithm>

namespace slicefarm::motion {

LayerPlace PlaceOf(const OrderedLayer& layer, std::span<const BlockVisit> visits,
                   const JobFacts& facts) {
  const LayerFrame& frame = layer.frame;
  LayerPlace place{visits.empty() ? 0 : visits.front().pass, frame.index, frame.index,
                   frame.print_z_nm, frame.print_z_nm};
  if (place.pass >= std::ssize(facts.passes)) return place;
  const PassFacts& pass = facts.passes[static_cast<size_t>(place.pass)];
  place.top_nm = std::max(place.top_nm, pass.top_before_nm);
  const auto copy =
      std::ranges::find_if(visits, [](const BlockVisit& visit) { return visit.copy >= 0; });
  if (copy == visits.end()) return place;  // of the plate alone, in the first pass
  const int32_t own = layer.blocks[static_cast<size_t>(copy->block)].layer;
  place.index = pass.first_layer + own;
  place.number = pass.layers_before + own;
  return place;
}

}  // namespace slicefarm::motion
