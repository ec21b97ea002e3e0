#include "services/ordering/algo/comb/curl_avoidance.h"

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
void CutBeginning(double length_nm, std::vector<Point>& path) {
  size_t first = 0;
  for (; first + 1 < path.size(); ++first) {
    const double step = Distance(path[first], path[first + 1]);
    if (step > length_nm) {
      path[first] = PointBetween(path[first], path[first + 1], length_nm / step);
      break;
    }
    length_nm -= step;
  }
  path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

CurlAvoidance::CurlAvoidance(MultiPolygon curled, const Box& bounds)
    : curled_(std::move(curled)), bounds_(bounds) {
  ForEachRing(curled_, [&](const Polygon& ring) { edges_.AddRing(ring); });
  edges_.Build();
}

bool CurlAvoidance::Meets(Point from, std::span<const Point> corners, Point to) const {
  if (edges_.empty()) return false;
  std::vector<Point> path{from};
  path.insert(path.end(), corners.begin(), corners.end());
  path.push_back(to);
  for (int end = 0; end < 2; ++end) {
    CutBeginning(kAtEndsNm, path);
    std::ranges::reverse(path);
  }
  if (path.size() < 2) return false;
  for (size_t i = 1; i < path.size(); ++i)
    if (edges_.Meets(path[i - 1], path[i])) return true;
  return edges_.Surrounds(path.front());
}

TravelPaths CurlAvoidance::PathsThrough(const MultiPolygon& region) const {
  return {Difference(region, curled_), kClearanceNm};
}

std::optional<std::vector<Point>> CurlAvoidance::Within(TravelPaths& region, Point from, Point to,
                                                        double longest_nm,
                                                        WorkBudget& budget) const {
  auto corners = region.Find(from, to, longest_nm, budget);
  if (corners && Meets(from, *corners, to)) return std::nullopt;
  return corners;
}

void CurlAvoidance::KeepOff(Point from, Point to, WorkBudget& budget, std::vector<Point>& corners) {
  if (!Meets(from, corners, to)) return;
  if (auto around = Around(from, to, budget)) corners = *std::move(around);
}

std::optional<std::vector<Point>> CurlAvoidance::Around(Point from, Point to, WorkBudget& budget) {
  if (!paths_) paths_.emplace(PathsThrough(RegionOf(bounds_)));
  return Within(*paths_, from, to, std::numeric_limits<double>::infinity(), budget);
}

}  // namespace slicefarm::ordering
