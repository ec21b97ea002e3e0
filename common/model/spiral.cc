#include "common/model/spiral.h"

#include <limits>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm {
namespace {

bool IsOneLoop(const MultiPolygon& region) {
  return region.size() == 1 && region.front().holes.empty();
}

}  // namespace

std::optional<Polygon> SpiralLoop(const MultiPolygon& outline, Coord width_nm) {
  if (!IsOneLoop(outline)) return std::nullopt;
  MultiPolygon inner = FastOffset(outline, -width_nm / 2);
  if (!IsOneLoop(inner)) return std::nullopt;
  return std::move(inner.front().outer);
}

Point NearestOnLoop(Point to, const Polygon& loop) {
  Point nearest = loop.front();
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < loop.size(); ++i) {
    const Point point = NearestOnSegment(to, loop[i], loop[(i + 1) % loop.size()]);
    const double distance = Distance(to, point);
    if (distance >= least) continue;
    least = distance;
    nearest = point;
  }
  return nearest;
}

}  // namespace slicefarm
