#include "services/ordering/algo/loop_start.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/measure.h"

namespace slicefarm::ordering {
namespace {

/// Factor by which a corner may be further away than the nearest point and still be preferred. At
/// an outline corner that points inwards, the corner of an inner loop is sqrt(2) times as far away
/// as the loop's edges, and it is still the best start.
constexpr double kCornerPreference = 1.5;
/// Distance from the seam, in nm, within which a corner is always accepted.
constexpr double kNearEnoughNm = 100'000;
/// Distance from the seam, in nm, within which any vertex is accepted, because a shorter move is
/// not useful.
constexpr double kSameNm = 50'000;
/// Two distances count as equal if they differ by at most this, in nm. Example: the corners of the
/// arc with which a loop rounds the outline corner at the seam.
constexpr double kAsNearNm = 20'000;
/// Length in nm of the arms before and after a corner, between which the turn is measured.
constexpr double kArmNm = 300'000;
constexpr double kCornerCosine = 0.906;  // cosine of 25 degrees

/// Returns the first point of the loop that is at least an arm away from `vertex`. `step`: 1
/// (forward) or size - 1 (backward).
Point ArmEnd(std::span<const Point> loop, size_t vertex, size_t step) {
  double length = 0;
  size_t i = vertex;
  do {
    const size_t next = (i + step) % loop.size();
    length += Distance(loop[i], loop[next]);
    i = next;
  } while (length < kArmNm && i != vertex);
  return loop[i];
}

/// Returns the cosine of the turn at `vertex`, or 0 if an arm has no length.
double TurnCosine(std::span<const Point> loop, size_t vertex) {
  const Point in = loop[vertex] - ArmEnd(loop, vertex, loop.size() - 1);
  const Point out = ArmEnd(loop, vertex, 1) - loop[vertex];
  const double lengths = Norm(in) * Norm(out);
  return lengths > 0 ? Dot(in, out) / lengths : 0;
}

/// Returns the corner nearest to `to` within `reach_nm`, the sharpest one if several are equally
/// near. Returns the loop's size if there is no such corner.
size_t NearestCorner(std::span<const Point> loop, Point to, double reach_nm) {
  double nearest = reach_nm;
  for (size_t i = 0; i < loop.size(); ++i) {
    const double distance = Distance(loop[i], to);
    if (distance < nearest && TurnCosine(loop, i) <= kCornerCosine) nearest = distance;
  }
  size_t best = loop.size();
  double sharpest = kCornerCosine;
  for (size_t i = 0; i < loop.size(); ++i) {
    if (Distance(loop[i], to) > std::min(nearest + kAsNearNm, reach_nm)) continue;
    const double cosine = TurnCosine(loop, i);
    if (cosine > sharpest || (cosine == sharpest && best < loop.size())) continue;
    best = i;
    sharpest = cosine;
  }
  return best;
}

/// Returns the width at the point `at` of an edge, interpolated between the edge's ends.
Coord WidthBetween(const Path& path, size_t edge, Point at) {
  const size_t next = (edge + 1) % path.points.size();
  const double length = Distance(path.points[edge], path.points[next]);
  const double share = length > 0 ? Distance(path.points[edge], at) / length : 0;
  const auto from = static_cast<double>(path.WidthAt(edge));
  const auto to = static_cast<double>(path.WidthAt(next));
  return std::llround(from + share * (to - from));
}

}  // namespace

LoopPoint NearestVertex(std::span<const Point> loop, Point to) {
  LoopPoint best;
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

LoopPoint NearestToSeam(std::span<const Point> loop, Point seam) {
  const LoopPoint start = NearestLoopPoint(loop, seam);
  const double distance = Distance(start.at, seam);
  const size_t corner = NearestCorner(loop, seam, kCornerPreference * distance + kNearEnoughNm);
  if (corner < loop.size()) return {corner, loop[corner]};
  const size_t next = start.edge + 1 < loop.size() ? start.edge + 1 : 0;
  if (Distance(start.at, loop[next]) <= kSameNm) return {next, loop[next]};
  if (Distance(start.at, loop[start.edge]) <= kSameNm) return {start.edge, loop[start.edge]};
  return start;
}

LoopPoint Further(std::span<const Point> loop, LoopPoint from, double by_nm) {
  const auto next_of = [&](size_t i) { return i + 1 < loop.size() ? i + 1 : 0; };
  double length = 0;
  for (size_t i = 0; i < loop.size(); ++i) length += Distance(loop[i], loop[next_of(i)]);
  if (length <= 0) return from;
  by_nm -= std::floor(by_nm / length) * length;
  LoopPoint at = from;
  for (;;) {
    const Point end = loop[next_of(at.edge)];
    const double left = Distance(at.at, end);
    if (by_nm < left) {
      const double share = by_nm / left;
      const Point route = end - at.at;
      const Point there = at.at + Point{std::llround(share * static_cast<double>(route.x)),
                                        std::llround(share * static_cast<double>(route.y))};
      if (there == end) return {next_of(at.edge), end};
      return {at.edge, there};
    }
    by_nm -= left;
    at = {next_of(at.edge), end};
  }
}

void StartAt(LoopPoint start, Path& loop) {
  size_t first = start.edge;
  if (start.at != loop.points[start.edge]) {
    first = start.edge + 1;
    const auto offset = static_cast<ptrdiff_t>(first);
    if (loop.widths_nm.size() > 1) {
      loop.widths_nm.insert(loop.widths_nm.begin() + offset,
                            WidthBetween(loop, start.edge, start.at));
    }
    loop.points.insert(loop.points.begin() + offset, start.at);
  }
  const auto offset = static_cast<ptrdiff_t>(first);
  std::rotate(loop.points.begin(), loop.points.begin() + offset, loop.points.end());
  if (loop.widths_nm.size() > 1) {
    std::rotate(loop.widths_nm.begin(), loop.widths_nm.begin() + offset, loop.widths_nm.end());
  }
}

}  // namespace slicefarm::ordering
