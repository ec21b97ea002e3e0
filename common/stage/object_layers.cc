#include "common/stage/object_layers.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm {
namespace {

/// First and last of a stack's own layers in a range of the job's layers.
struct OwnLayers {
  int32_t first = 0;
  int32_t last = 0;
  int32_t count = 0;  ///< number of layers of the stack
};

std::map<int32_t, OwnLayers> LayersOfStacks(std::span<const SlicedLayer> layers) {
  std::map<int32_t, OwnLayers> own;
  for (const SlicedLayer& layer : layers) {
    for (const ObjectSection& section : layer.sections) {
      const auto [place, is_new] = own.try_emplace(
          section.stack.id, OwnLayers{section.layer, section.layer, section.layer_count});
      place->second.first = std::min(place->second.first, section.layer);
      place->second.last = std::max(place->second.last, section.layer);
    }
  }
  return own;
}

const ObjectSection* SectionOf(const SlicedLayer& layer, int32_t stack) {
  const auto found = std::ranges::lower_bound(
      layer.sections, stack, {}, [](const ObjectSection& section) { return section.stack.id; });
  return found != layer.sections.end() && found->stack.id == stack ? &*found : nullptr;
}

/// Goes from layer `from` in steps until a layer contains the stack's own layer `wanted`. Returns
/// the index of this layer. If there is none, returns the index of the last layer that has a
/// section of the stack.
int32_t Reach(std::span<const SlicedLayer> layers, int32_t stack, int32_t from, int32_t step,
              int32_t wanted) {
  int32_t at = from;
  for (int32_t i = from; i >= 0 && i < std::ssize(layers); i += step) {
    const ObjectSection* section = SectionOf(layers[static_cast<size_t>(i)], stack);
    if (section == nullptr) continue;
    at = i;
    if (step < 0 ? section->layer <= wanted : section->layer >= wanted) break;
  }
  return at;
}

}  // namespace

ObjectLayers::ObjectLayers(std::span<const SlicedLayer> layers) {
  for (const SlicedLayer& layer : layers) {
    for (const ObjectSection& section : layer.sections) {
      Sections& own = stacks_[section.stack.id];
      if (own.sections.empty()) own.first = section.layer;
      // A gap or a step back violates the condition of SlicedLayer. Layers after it are not found.
      if (section.layer == own.first + std::ssize(own.sections)) own.sections.push_back(&section);
    }
  }
}

const ObjectSection* ObjectLayers::Find(int32_t stack, int32_t layer) const {
  const auto found = stacks_.find(stack);
  if (found == stacks_.end()) return nullptr;
  const int64_t at = int64_t{layer} - found->second.first;
  if (at < 0 || at >= std::ssize(found->second.sections)) return nullptr;
  return found->second.sections[static_cast<size_t>(at)];
}

LayerRange WithHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo) {
  LayerRange all = range;
  const auto own = LayersOfStacks(
      layers.subspan(static_cast<size_t>(range.first), static_cast<size_t>(range.size())));
  for (const auto& [stack, has] : own) {
    all.first = std::min(all.first, Reach(layers, stack, range.first, -1, has.first - halo));
    all.last = std::max(all.last, 1 + Reach(layers, stack, range.last - 1, 1, has.last + halo));
  }
  return all;
}

absl::Status CheckHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo) {
  const int32_t sent_from = layers.empty() ? 0 : layers.front().frame.index;
  if (range.first < sent_from || range.size() < 0 ||
      int64_t{range.last} - sent_from > std::ssize(layers))
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("layers [{}, {}) did not all come", range.first, range.last),
                     {{"field", "layer"}});
  const auto in_range = layers.subspan(static_cast<size_t>(range.first - sent_from),
                                       static_cast<size_t>(range.size()));
  const ObjectLayers there(layers);
  for (const auto& [stack, has] : LayersOfStacks(in_range)) {
    const int32_t first = std::max(0, has.first - halo);
    const int32_t last = std::min(has.count, has.last + 1 + halo);
    for (int32_t layer = first; layer < last; ++layer) {
      if (there.Find(stack, layer) != nullptr) continue;
      return MakeError(
          absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
          fmt::format("layer {} of stack {} did not come; the settings want the stack's layers "
                      "[{}, {}) for the range",
                      layer, stack, first, last),
          {{"field", "layer"}});
    }
  }
  return absl::OkStatus();
}

int64_t PointsIn(std::span<const SlicedLayer> layers) {
  int64_t points = 0;
  for (const SlicedLayer& layer : layers)
    for (const ObjectSection& section : layer.sections)
      for (const Region& region : section.regions)
        points += static_cast<int64_t>(PointCount(region.outlines));
  return points;
}

}  // namespace slicefarm
