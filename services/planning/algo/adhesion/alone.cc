#include "services/planning/algo/adhesion/alone.h"

#include "common/geometry/boolean/boolean.h"

namespace slicefarm::planning {
namespace {

bool LeavesBed(const Box& box, const MultiPolygon& bed) {
  const Polygon ring = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return !Difference({{ring, {}}}, bed).empty();
}

}  // namespace

std::set<int32_t> ObjectsAlone(std::span<const CopyFootprint> copies, const MultiPolygon& bed) {
  std::set<int32_t> alone, not_alone;
  for (size_t i = 0; i < copies.size(); ++i) {
    const CopyFootprint& copy = copies[i];
    if (copy.box.Empty() || not_alone.contains(copy.object)) continue;
    alone.insert(copy.object);
    bool meets = LeavesBed(copy.box, bed);
    for (size_t k = 0; k < copies.size() && !meets; ++k)
      meets = k != i && !copies[k].box.Empty() && copies[k].box.Intersects(copy.box);
    if (meets) not_alone.insert(copy.object);
  }
  for (const int32_t object : not_alone) alone.erase(object);
  return alone;
}

}  // namespace slicefarm::planning
