#include "common/geometry/rings/loop_point.h"

#include <limits>

#include "common/geometry/measure.h"

namespace slicefarm {

LoopPoint NearestLoopPoint(std::span<const Point> loop, Point to) {
  LoopPoint best{0, loop[0]};
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < loop.size(); ++i) {
    const Point next = loop[i + 1 < loop.size() ? i + 1 : 0];
    const double distance = DistanceToSegment(to, loop[i], next);
    if (distance >= least) continue;
    best = {i, NearestOnSegment(to, loop[i], next)};
    least = distance;
  }
  return best;
}

}  // namespace slicefarm
