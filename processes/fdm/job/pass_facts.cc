#include "processes/fdm/job/pass_facts.h"

#include <algorithm>
#include <map>

namespace slicefarm::coordinator {
namespace {

/// Layers of the job from the object's first layer to the last layer in which the object is
/// printed.
struct Extent {
  int32_t first = 0;
  int32_t layers = 0;  ///< number of layers of the object's own stack
  Coord top_nm = 0;
};

std::map<int32_t, Extent> Extents(std::span<const SlicedLayer> layers) {
  std::map<int32_t, Extent> extents;
  for (const SlicedLayer& layer : layers)
    for (const ObjectSection& section : layer.sections) {
      if (!section.stack.IsPart()) continue;
      const auto [extent, is_new] =
          extents.try_emplace(section.stack.object, Extent{layer.frame.index, 0, 0});
      if (section.regions.empty()) continue;
      extent->second.layers = section.layer + 1;
      extent->second.top_nm = layer.frame.print_z_nm;
    }
  return extents;
}

}  // namespace

PassPlan PassesOf(std::span<const SlicedLayer> layers, std::span<const Copy> copies) {
  int32_t count = 1;
  for (const Copy& copy : copies) count = std::max(count, copy.pass + 1);
  PassPlan plan;
  plan.layer_count = static_cast<int32_t>(layers.size());
  if (count == 1) return plan;

  const std::map<int32_t, Extent> extents = Extents(layers);
  plan.passes.resize(static_cast<size_t>(count));
  std::vector<Extent> of_pass(plan.passes.size());
  for (const Copy& copy : copies) {
    const auto found = extents.find(copy.object);
    if (found == extents.end()) continue;
    Extent& extent = of_pass[static_cast<size_t>(copy.pass)];
    extent.first = found->second.first;
    extent.layers = std::max(extent.layers, found->second.layers);
    extent.top_nm = std::max(extent.top_nm, found->second.top_nm);
  }
  plan.layer_count = of_pass[0].first;
  Coord top_nm = 0;
  for (size_t i = 0; i < of_pass.size(); ++i) {
    plan.passes[i] = {plan.layer_count, of_pass[i].first, top_nm};
    plan.layer_count += of_pass[i].layers;
    top_nm = std::max(top_nm, of_pass[i].top_nm);
  }
  return plan;
}

}  // namespace slicefarm::coordinator
