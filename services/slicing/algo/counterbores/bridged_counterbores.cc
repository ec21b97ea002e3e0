#include "services/slicing/algo/counterbores/bridged_counterbores.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/slicing/algo/counterbores/counterbore.h"

namespace slicefarm::slicing {
namespace {

/// Changes to one section: the areas to cut out and the areas to fill.
struct Edit {
  MultiPolygon cut;
  MultiPolygon filled;
};

/// Returns true if the holes continue through `outlines`. A draft angle may cover up to 2 % of
/// their area.
bool GoThrough(const MultiPolygon& holes, const MultiPolygon& outlines) {
  constexpr double kDraft = 0.02;
  return Area(Intersection(holes, outlines)) <= kDraft * Area(holes);
}

void CutOut(const MultiPolygon& area, ObjectSection& section) {
  for (Region& region : section.regions) region.outlines = Difference(region.outlines, area);
  std::erase_if(section.regions, [](const Region& region) { return region.outlines.empty(); });
  section.whole = section.regions.size() > 1 ? Difference(section.whole, area) : MultiPolygon{};
}

/// Fills each hole. It is added to the region that touches the largest part of the hole's boundary.
void FillUp(const MultiPolygon& holes, ObjectSection& section) {
  constexpr Coord kEdgeNm = 50'000;
  for (const PolygonWithHoles& hole : holes) {
    const MultiPolygon edge = FastOffset({hole}, kEdgeNm);
    const auto region = std::ranges::max_element(section.regions, {}, [&](const Region& each) {
      return Area(Intersection(each.outlines, edge));
    });
    if (region != section.regions.end()) region->outlines = Union(region->outlines, {hole});
  }
  if (section.regions.size() > 1) section.whole = Union(section.whole, holes);
}

/// Returns the counterbores of each layer, without holes that are open in one layer only. Example
/// of such a hole: the last slit below the top of a round horizontal channel, which the next layer
/// closes anyway.
std::vector<std::vector<Counterbore>> Found(std::span<ObjectSection* const> sections, int threads,
                                            const CancelToken& cancel) {
  std::vector<std::vector<Counterbore>> found(sections.size());
  ForEachIndex(threads, sections.size(), [&](size_t layer, int) {
    if (cancel.Cancelled() || layer == 0 || layer + 1 >= sections.size() || sections[layer]->hollow)
      return;
    found[layer] = CounterboresOver(OutlineOf(*sections[layer - 1]), OutlineOf(*sections[layer]));
    std::erase_if(found[layer], [&](const Counterbore& each) {
      return !GoThrough(each.holes, OutlineOf(*sections[layer + 1]));
    });
  });
  return found;
}

}  // namespace

void BridgeCounterbores(CounterboreBridging how, std::span<ObjectSection* const> sections,
                        int threads, const CancelToken& cancel) {
  if (how == CounterboreBridging::kNone) return;
  const std::vector<std::vector<Counterbore>> found = Found(sections, threads, cancel);
  std::vector<Edit> edits(sections.size());
  for (size_t layer = 0; layer < sections.size(); ++layer)
    for (const Counterbore& counterbore : found[layer]) {
      if (how == CounterboreBridging::kSacrificial) {
        MultiPolygon& filled = edits[layer].filled;
        filled = Union(filled, counterbore.holes);
        continue;
      }
      for (size_t i = 0; i < counterbore.open_areas.size() && layer + i < sections.size(); ++i) {
        if (!GoThrough(counterbore.holes, OutlineOf(*sections[layer + i]))) break;
        MultiPolygon& cut = edits[layer + i].cut;
        cut = Union(cut, counterbore.open_areas[i]);
      }
    }
  for (size_t layer = 0; layer < sections.size() && !cancel.Cancelled(); ++layer) {
    if (!edits[layer].cut.empty()) CutOut(edits[layer].cut, *sections[layer]);
    if (!edits[layer].filled.empty()) FillUp(edits[layer].filled, *sections[layer]);
  }
}

}  // namespace slicefarm::slicing
