#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/path.h"

/// Checks of the distances between beads, and between beads and an edge, by points along the beads.
/// They do not use the code that creates the beads.
namespace slicefarm::infill {

/// Point on a path, with the path's direction there.
struct BeadPoint {
  double x = 0, y = 0;
  double pass_x = 0, pass_y = 0;  ///< direction as a unit vector
  size_t path = 0;
  double along_nm = 0;  ///< distance from the path's start
};

inline constexpr double kBeadStepNm = 50'000;

/// Returns the middles of steps of at most kBeadStepNm, each with the length of its step.
inline std::vector<std::pair<BeadPoint, double>> BeadPoints(const std::vector<Path>& paths) {
  std::vector<std::pair<BeadPoint, double>> points;
  for (size_t k = 0; k < paths.size(); ++k) {
    const std::vector<Point>& line = paths[k].points;
    double along = 0;
    for (size_t i = 1; i < line.size() + (paths[k].closed ? 1 : 0); ++i) {
      const Point a = line[i - 1], route = line[i % line.size()] - a;
      const double length = Distance({0, 0}, route);
      if (length == 0) continue;
      const double x = static_cast<double>(route.x), y = static_cast<double>(route.y);
      const double steps = std::ceil(length / kBeadStepNm);
      for (double s = 0.5; s < steps; ++s) {
        points.push_back(
            {{static_cast<double>(a.x) + s / steps * x, static_cast<double>(a.y) + s / steps * y,
              x / length, y / length, k, along + s / steps * length},
             length / steps});
      }
      along += length;
    }
  }
  return points;
}

/// Returns the length that is on another bead of about the same direction (16 degrees). A bead's
/// own path within three widths along it does not count.
inline double DoubledLength(const std::vector<Path>& paths, double width_nm) {
  const auto points = BeadPoints(paths);
  const auto square = [width_nm](const BeadPoint& p) {
    return std::pair(std::llround(std::floor(p.x / width_nm)),
                     std::llround(std::floor(p.y / width_nm)));
  };
  std::map<std::pair<int64_t, int64_t>, std::vector<BeadPoint>> by_square;
  for (const auto& [point, step] : points) by_square[square(point)].push_back(point);
  const auto lie_on_each_other = [width_nm](const BeadPoint& p, const BeadPoint& q) {
    if (p.path == q.path && std::abs(p.along_nm - q.along_nm) < 3 * width_nm) return false;
    if (std::abs(p.pass_x * q.pass_y - p.pass_y * q.pass_x) > std::sin(16 * 0.0174533))
      return false;
    return std::hypot(p.x - q.x, p.y - q.y) < 0.6 * width_nm;
  };
  double doubled = 0;
  for (const auto& [point, step] : points) {
    const auto [column, row] = square(point);
    bool found = false;
    for (int64_t i = column - 1; i <= column + 1; ++i)
      for (int64_t j = row - 1; j <= row + 1; ++j)
        if (const auto near = by_square.find({i, j}); near != by_square.end())
          found = found || std::ranges::any_of(near->second, [&, p = point](const BeadPoint& q) {
                    return lie_on_each_other(p, q);
                  });
    if (found) doubled += step;
  }
  return doubled;
}

/// Returns the length of the parts of beads with a centre line at most `depth_nm` from a region's
/// edge.
inline double LengthAlongEdge(const std::vector<Path>& paths, const MultiPolygon& region,
                              double depth_nm) {
  double length = 0;
  for (const auto& [point, step] : BeadPoints(paths)) {
    const Point at{std::llround(point.x), std::llround(point.y)};
    bool near = false;
    ForEachRing(region, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size() && !near; ++i)
        near = DistanceToSegment(at, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]) <= depth_nm;
    });
    if (near) length += step;
  }
  return length;
}

}  // namespace slicefarm::infill
