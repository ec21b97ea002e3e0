#include "common/stage/print_layers.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace slicefarm {
namespace {

using SectionsByTop = std::map<Coord, std::vector<ObjectSection>>;

Coord LiftOf(const Stack& stack, std::span<const Coord> lifts_nm) {
  const auto object = static_cast<size_t>(stack.object);
  return object < lifts_nm.size() ? lifts_nm[object] : 0;
}

/// Returns true if the print consists of the unchanged parts: nothing is lifted or added.
bool AreThePrint(std::span<const Coord> lifts_nm, std::span<const AddedStack> added) {
  return added.empty() && std::ranges::all_of(lifts_nm, [](Coord lift_nm) { return lift_nm == 0; });
}

void AddParts(std::vector<SlicedLayer> parts, std::span<const Coord> lifts_nm,
              SectionsByTop& by_top) {
  for (SlicedLayer& layer : parts) {
    if (layer.sections.empty()) by_top.try_emplace(layer.frame.print_z_nm);
    for (ObjectSection& section : layer.sections)
      by_top[layer.frame.print_z_nm + LiftOf(section.stack, lifts_nm)].push_back(
          std::move(section));
  }
}

}  // namespace

size_t PrintLayerCount(std::span<const SlicedLayer> parts, std::span<const Coord> lifts_nm,
                       std::span<const AddedStack> added) {
  if (AreThePrint(lifts_nm, added)) return parts.size();
  std::set<Coord> tops;
  for (const SlicedLayer& layer : parts) {
    if (layer.sections.empty()) tops.insert(layer.frame.print_z_nm);
    for (const ObjectSection& section : layer.sections)
      tops.insert(layer.frame.print_z_nm + LiftOf(section.stack, lifts_nm));
  }
  for (const AddedStack& stack : added)
    for (const ObjectSection& section : stack.sections) tops.insert(stack.lift_nm + section.z_nm);
  return tops.size();
}

std::vector<SlicedLayer> PrintLayers(std::vector<SlicedLayer> parts,
                                     std::span<const Coord> lifts_nm,
                                     std::vector<AddedStack> added) {
  if (AreThePrint(lifts_nm, added)) return parts;
  SectionsByTop by_top;
  AddParts(std::move(parts), lifts_nm, by_top);
  for (AddedStack& stack : added)
    for (ObjectSection& section : stack.sections)
      by_top[stack.lift_nm + section.z_nm].push_back(std::move(section));
  std::vector<SlicedLayer> layers;
  layers.reserve(by_top.size());
  Coord below_nm = 0;
  for (auto& [top_nm, sections] : by_top) {
    std::ranges::sort(sections, {}, [](const ObjectSection& section) { return section.stack.id; });
    const auto index = static_cast<int32_t>(layers.size());
    layers.push_back({{index, top_nm, top_nm - below_nm}, std::move(sections)});
    below_nm = top_nm;
  }
  return layers;
}

}  // namespace slicefarm
