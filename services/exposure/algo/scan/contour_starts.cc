#include "services/exposure/algo/scan/contour_starts.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/measure.h"
#include "services/exposure/algo/scan/ring_starts.h"

namespace slicefarm::exposure {
namespace {

Polyline FromCorner(const Polygon& ring, Polygon::const_iterator first) {
  Polyline line(first, ring.end());
  line.insert(line.end(), ring.begin(), first);
  line.push_back(line.front());
  return line;
}

}  // namespace

Polyline StartedContour(const Polygon& ring, ContourStart start, double share, Point at) {
  switch (start) {
    case ContourStart::kNearest:
      return FromCorner(ring, std::ranges::min_element(
                                  ring, {}, [&](Point corner) { return Distance(corner, at); }));
    case ContourStart::kRear:
      return FromCorner(ring, std::ranges::max_element(ring, {}, [](Point corner) {
                          return std::pair(corner.y, corner.x);
                        }));
    case ContourStart::kScattered:
      break;
  }
  std::vector<Polyline> lines = {FromCorner(ring, ring.begin())};
  StartAtShare(lines, share);
  return std::move(lines.front());
}

}  // namespace slicefarm::exposure
