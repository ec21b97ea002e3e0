#include "services/ordering/algo/comb/curled_ways.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/geometry/between.h"
#include "common/geometry/boolean/boolean.h"

namespace slicefarm::ordering {
namespace {

constexpr Coord kClearanceNm = 250'000;
/// Length in nm at either end of a travel that may cross a curled area.
constexpr double kAtEndsNm = 1.5 * kNmPerMm;

/// Cuts `length_nm` off the beginning of a path. A shorter path becomes a single point.
void CutBeginning(double length_nm, std::vector<Point>& way) {
  size_t first = 0;
  for (; first + 1 < way.size(); ++first) {
    const double step = Distance(way[first], way[first + 1]);
    if (step > length_nm) {
      way[first] = PointBetween(way[first], way[first + 1], length_nm / step);
      break;
    }
    length_nm -= step;
  }
  way.erase(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

CurledWays::CurledWays(MultiPolygon curled, const Box& room)
    : curled_(std::move(curled)), room_(room) {
  ForEachRing(curled_, [&](const Polygon& ring) { edges_.AddRing(ring); });
  edges_.Build();
}

bool CurledWays::Meets(Point from, std::span<const Point> corners, Point to) const {
  if (edges_.empty()) return false;
  std::vector<Point> way{from};
  way.insert(way.end(), corners.begin(), corners.end());
  way.push_back(to);
  for (int end = 0; end < 2; ++end) {
    CutBeginning(kAtEndsNm, way);
    std::ranges::reverse(way);
  }
  if (way.size() < 2) return false;
  for (size_t i = 1; i < way.size(); ++i)
    if (edges_.Meets(way[i - 1], way[i])) return true;
  return edges_.Surrounds(way.front());
}

ClearWays CurledWays::WaysThrough(const MultiPolygon& region) const {
  return {Difference(region, curled_), kClearanceNm};
}

std::optional<std::vector<Point>> CurledWays::Within(ClearWays& region, Point from, Point to,
                                                     double longest_nm,
                                                     WorkBudget& budget) const {
  auto corners = region.Find(from, to, longest_nm, budget);
  if (corners && Meets(from, *corners, to)) return std::nullopt;
  return corners;
}

void CurledWays::KeepOff(Point from, Point to, WorkBudget& budget, std::vector<Point>& corners) {
  if (!Meets(from, corners, to)) return;
  if (auto around = Around(from, to, budget)) corners = *std::move(around);
}

std::optional<std::vector<Point>> CurledWays::Around(Point from, Point to, WorkBudget& budget) {
  if (!ways_) ways_.emplace(WaysThrough(RegionOf(room_)));
  return Within(*ways_, from, to, std::numeric_limits<double>::infinity(), budget);
}

}  // namespace slicefarm::ordering
