#include "services/planning/algo/infill/grid_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace slicefarm::planning {
namespace {

/// Returns the first multiple of `step` that is not below `at`, in steps.
Coord StepsUp(Coord at, Coord step) { return at >= 0 ? (at + step - 1) / step : -(-at / step); }

}  // namespace

std::vector<Point> GridPoints(const MultiPolygon& region, Coord step_nm) {
  std::map<Coord, std::vector<double>> rows;  // x of the crossings in each row
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a.y > b.y) std::swap(a, b);
      for (Coord row = StepsUp(a.y, step_nm); row * step_nm < b.y; ++row) {
        const double share =
            static_cast<double>(row * step_nm - a.y) / static_cast<double>(b.y - a.y);
        rows[row].push_back(static_cast<double>(a.x) + share * static_cast<double>(b.x - a.x));
      }
    }
  });
  std::vector<Point> points;
  for (auto& [row, crossings] : rows) {
    std::ranges::sort(crossings);
    for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto first = static_cast<Coord>(std::ceil(crossings[i]));
      for (Coord x = StepsUp(first, step_nm) * step_nm; static_cast<double>(x) < crossings[i + 1];
           x += step_nm)
        points.push_back({x, row * step_nm});
    }
  }
  return points;
}

}  // namespace slicefarm::planning
