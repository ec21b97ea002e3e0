#include "services/ordering/algo/loop_start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/measure.h"

namespace slicefarm::ordering {
namespace {

/// Around a corner of an outline that points inwards, the corner of a loop inside lies sqrt(2)
/// times as far away as its edges; it still is the place to start.
constexpr double kCornerPreference = 1.5;
/// A vertex this near to a seam always will do.
constexpr double kNearEnoughNm = 100'000;

/// Width at `at` between the points of an edge.
Coord WidthBetween(const Path& path, size_t edge, Point at) {
  const size_t next = (edge + 1) % path.points.size();
  const double length = Distance(path.points[edge], path.points[next]);
  const double share = length > 0 ? Distance(path.points[edge], at) / length : 0;
  const auto from = static_cast<double>(path.WidthAt(edge));
  const auto to = static_cast<double>(path.WidthAt(next));
  return std::llround(from + share * (to - from));
}

}  // namespace

LoopPlace NearestVertex(std::span<const Point> loop, Point to) {
  LoopPlace best;
  double best_distance2 = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < loop.size(); ++i) {
    const double distance2 = SquaredNorm(loop[i] - to);
    if (distance2 > best_distance2 || (distance2 == best_distance2 && !(loop[i] < best.at))) {
      continue;
    }
    best = {i, loop[i]};
    best_distance2 = distance2;
  }
  return best;
}

LoopPlace NearestToSeam(std::span<const Point> loop, Point seam) {
  const LoopPlace vertex = NearestVertex(loop, seam);
  const double to_vertex = Distance(vertex.at, seam);
  if (to_vertex <= kNearEnoughNm) return vertex;
  LoopPlace inside = vertex;
  double to_inside = to_vertex;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Point next = loop[i + 1 < loop.size() ? i + 1 : 0];
    const double distance = DistanceToSegment(seam, loop[i], next);
    if (distance >= to_inside) continue;
    inside = {i, NearestOnSegment(seam, loop[i], next)};
    to_inside = distance;
  }
  if (to_vertex <= kCornerPreference * to_inside + kNearEnoughNm) return vertex;
  // The end of an edge is the start of the next.
  const size_t next = inside.edge + 1 < loop.size() ? inside.edge + 1 : 0;
  return inside.at == loop[next] ? LoopPlace{next, inside.at} : inside;
}

void StartAt(LoopPlace place, Path& loop) {
  size_t first = place.edge;
  if (place.at != loop.points[place.edge]) {
    first = place.edge + 1;
    const auto offset = static_cast<ptrdiff_t>(first);
    if (loop.widths_nm.size() > 1) {
      loop.widths_nm.insert(loop.widths_nm.begin() + offset,
                            WidthBetween(loop, place.edge, place.at));
    }
    loop.points.insert(loop.points.begin() + offset, place.at);
  }
  const auto offset = static_cast<ptrdiff_t>(first);
  std::rotate(loop.points.begin(), loop.points.begin() + offset, loop.points.end());
  if (loop.widths_nm.size() > 1) {
    std::rotate(loop.widths_nm.begin(), loop.widths_nm.begin() + offset, loop.widths_nm.end());
  }
}

}  // namespace slicefarm::ordering
