#include "services/planning/algo/infill/sparse_areas.h"

#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::planning {
namespace {

/// Distance in nm by which rounding may shrink a region after an inward and an outward offset.
constexpr Coord kRoundedNm = 10'000;

using Outlines = MultiPolygon StackLayer::*;

/// Returns the part of `area` that the `outlines` of `count` layers above (or below) cover. In a
/// prism all outlines are equal, so no intersection is needed.
MultiPolygon Covered(MultiPolygon area, const ObjectStack& stack, Outlines outlines, size_t layer,
                     int32_t step, int32_t count, const ShellExtra& spare) {
  const MultiPolygon* nearer = &(stack[layer].*outlines);
  Coord between_nm = 0;
  for (int32_t i = 1; i <= count && !area.empty(); ++i) {
    if (IsSpared(spare, count, i, between_nm)) break;
    const int64_t other = static_cast<int64_t>(layer) + static_cast<int64_t>(i) * step;
    if (other < 0 || other >= std::ssize(stack)) return {};
    const MultiPolygon& cover = stack[static_cast<size_t>(other)].*outlines;
    if (cover != *nearer) area = Intersection(area, cover);
    nearer = &cover;
    between_nm += stack[static_cast<size_t>(other)].height_nm;
  }
  return area;
}

}  // namespace

std::vector<MultiPolygon> InnerAreas(const ObjectStack& stack, Coord walls_nm) {
  std::vector<MultiPolygon> inner;
  inner.reserve(stack.size());
  for (size_t i = 0; i < stack.size(); ++i) {
    const bool is_prism = i > 0 && stack[i].region == stack[i - 1].region;
    inner.push_back(is_prism ? inner.back() : FastOffset(stack[i].region, -walls_nm));
  }
  return inner;
}

std::vector<MultiPolygon> SparseAreas(const ObjectStack& stack, std::vector<MultiPolygon> inner,
                                      const SkinRules& rules) {
  const Outlines outlines = rules.of_region_alone ? &StackLayer::region : &StackLayer::whole;
  for (size_t i = 0; i < stack.size(); ++i) {
    MultiPolygon& area = inner[i];
    area = Covered(std::move(area), stack, outlines, i, 1, rules.top_solid_layers, rules.top_spare);
    area = Covered(std::move(area), stack, outlines, i, -1, rules.bottom_solid_layers,
                   rules.bottom_spare);
  }
  return inner;
}

std::vector<MultiPolygon> HollowAreas(const std::vector<MultiPolygon>& inner,
                                      const std::vector<MultiPolygon>& areas, Coord least_nm) {
  std::vector<MultiPolygon> hollow;
  hollow.reserve(areas.size());
  for (size_t i = 0; i < areas.size(); ++i) {
    const MultiPolygon solid =
        areas[i] == inner[i] ? MultiPolygon{} : Difference(inner[i], areas[i]);
    const MultiPolygon core = FastOffset(solid, -least_nm / 2);
    hollow.push_back(solid.empty() ? areas[i]
                     : core.empty()
                         ? inner[i]
                         : Difference(inner[i], FastOffset(core, least_nm / 2 + kRoundedNm)));
  }
  return hollow;
}

std::vector<MultiPolygon> RoofsOf(const std::vector<MultiPolygon>& areas) {
  std::vector<MultiPolygon> roofs;
  roofs.reserve(areas.size());
  for (size_t i = 0; i < areas.size(); ++i) {
    if (i + 1 == areas.size()) {
      roofs.push_back(areas[i]);
    } else {
      roofs.push_back(areas[i] == areas[i + 1] ? MultiPolygon{}
                                               : Difference(areas[i], areas[i + 1]));
    }
  }
  return roofs;
}

}  // namespace slicefarm::planning
