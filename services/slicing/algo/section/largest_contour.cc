#include "services/slicing/algo/section/largest_contour.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"

namespace slicefarm::slicing {
namespace {

double OuterArea(const PolygonWithHoles& island) { return std::abs(SignedArea(island.outer)); }

MultiPolygon LargestContour(const MultiPolygon& outline) {
  return {{std::ranges::max_element(outline, {}, OuterArea)->outer, {}}};
}

}  // namespace

void KeepLargestContour(ObjectSection& section) {
  const MultiPolygon& outline = OutlineOf(section);
  if (outline.empty() || (outline.size() == 1 && outline.front().holes.empty())) return;
  MultiPolygon contour = LargestContour(outline);
  if (section.regions.size() == 1) {
    section.regions.front().outlines = std::move(contour);
    return;
  }
  MultiPolygon rest = contour;
  for (size_t i = 1; i < section.regions.size(); ++i) {
    MultiPolygon& own = section.regions[i].outlines;
    own = Intersection(own, contour);
    rest = Difference(rest, own);
  }
  section.regions.front().outlines = std::move(rest);
  std::erase_if(section.regions, [](const Region& region) { return region.outlines.empty(); });
  section.whole = section.regions.size() > 1 ? std::move(contour) : MultiPolygon{};
}

}  // namespace slicefarm::slicing
