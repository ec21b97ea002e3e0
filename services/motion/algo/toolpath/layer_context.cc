#include "services/motion/algo/toolpath/layer_context.h"

#include <algorithm>

namespace slicefarm::motion {

LayerContext ContextOf(const OrderedLayer& layer, std::span<const BlockVisit> visits,
                       const JobFacts& facts) {
  const LayerFrame& frame = layer.frame;
  LayerContext context{visits.empty() ? 0 : visits.front().pass, frame.index, frame.index,
                       frame.print_z_nm, frame.print_z_nm};
  if (context.pass >= std::ssize(facts.passes)) return context;
  const PassFacts& pass = facts.passes[static_cast<size_t>(context.pass)];
  context.top_nm = std::max(context.top_nm, pass.top_before_nm);
  // Only layers of the part are counted. A layer with supports only, between two layers of the
  // part, gets the number of a layer of the part.
  const auto part = std::ranges::find_if(visits, [&](const BlockVisit& visit) {
    return layer.blocks[static_cast<size_t>(visit.block)].stack.IsPart();
  });
  if (part == visits.end()) {
    const bool of_copy = !visits.empty() && visits.back().copy >= 0;
    if (of_copy) context.number = pass.layers_before + std::max(0, frame.index - pass.first_layer);
    return context;  // otherwise the layer has only plate items
  }
  const int32_t own = layer.blocks[static_cast<size_t>(part->block)].layer;
  context.index = pass.first_layer + own;
  context.number = pass.layers_before + own;
  return context;
}

}  // namespace slicefarm::motion
