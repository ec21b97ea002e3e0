#include "services/texture/algo/paths/level_lines.h"

#include <algorithm>
#include <utility>

namespace slicefarm::texture {
namespace {

/// Walk along one level. A triangle with vertices on both sides is entered across the side where
/// the field falls and left across the side where it rises.
class LevelWalk {
 public:
  LevelWalk(const SurfaceMap& map, std::span<const double> field, double level)
      : map_(map), field_(field), level_(level) {}

  /// Returns the corner of the side by which the line leaves the triangle.
  int SideOut(int32_t triangle) const { return SideWhere(triangle, true); }
  int SideIn(int32_t triangle) const { return SideWhere(triangle, false); }

  EdgePoint EdgePointOn(int32_t triangle, int corner) const {
    const auto& corners = map_.mesh().triangles[triangle];
    const auto [low, high] = std::minmax(corners[corner], corners[(corner + 1) % 3]);
    const double share = (level_ - field_[low]) / (field_[high] - field_[low]);
    return {low, high, std::clamp(share, 0.0, 1.0)};
  }

 private:
  bool IsAbove(int32_t vertex) const { return field_[vertex] >= level_; }

  /// Returns the side where the field rises or falls, counter-clockwise around a triangle. A line
  /// with the larger values on its left leaves where the field rises and enters where it falls.
  int SideWhere(int32_t triangle, bool rises) const {
    const auto& corners = map_.mesh().triangles[triangle];
    for (int k = 0; k < 3; ++k) {
      const bool from = IsAbove(corners[k]), to = IsAbove(corners[(k + 1) % 3]);
      if (from != to && to == rises) return k;
    }
    return -1;
  }

  const SurfaceMap& map_;
  std::span<const double> field_;
  double level_;
};

/// Returns the triangles that each level passes, ascending.
std::vector<std::vector<int32_t>> TrianglesByLevel(const SurfaceMap& map,
                                                   std::span<const double> field,
                                                   std::span<const double> levels) {
  std::vector<std::vector<int32_t>> by_level(levels.size());
  const auto& triangles = map.mesh().triangles;
  for (size_t t = 0; t < triangles.size(); ++t) {
    const auto [low, high] =
        std::minmax({field[triangles[t][0]], field[triangles[t][1]], field[triangles[t][2]]});
    auto level = std::upper_bound(levels.begin(), levels.end(), low);
    for (; level != levels.end() && *level <= high; ++level)
      by_level[level - levels.begin()].push_back(static_cast<int32_t>(t));
  }
  return by_level;
}

/// Walks from a triangle to the boundary, or once around, and marks triangles as used.
LevelLine LineFrom(const SurfaceMap& map, const LevelWalk& walk, int32_t start,
                   std::vector<bool>* open) {
  LevelLine line;
  line.points.push_back(walk.EdgePointOn(start, walk.SideIn(start)));
  for (int32_t at = start; at >= 0 && (*open)[at];) {
    (*open)[at] = false;
    const int out = walk.SideOut(at);
    line.triangles.push_back(at);
    line.points.push_back(walk.EdgePointOn(at, out));
    at = map.Neighbour(at, out);
  }
  return line;
}

}  // namespace

absl::StatusOr<std::vector<LevelSet>> LevelLines(const SurfaceMap& map,
                                                 std::span<const double> field,
                                                 std::span<const double> levels,
                                                 const CancelToken& cancel) {
  std::vector<LevelSet> sets(levels.size());
  const auto by_level = TrianglesByLevel(map, field, levels);
  std::vector<bool> open(map.mesh().triangles.size(), false);
  for (size_t i = 0; i < levels.size(); ++i) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const LevelWalk walk(map, field, levels[i]);
    for (const int32_t t : by_level[i]) open[t] = true;
    for (const int32_t t : by_level[i])
      if (open[t] && map.Neighbour(t, walk.SideIn(t)) < 0)
        sets[i].lines.push_back(LineFrom(map, walk, t, &open));
    for (const int32_t t : by_level[i])  // the remaining lines are closed
      if (open[t]) sets[i].lines.push_back(LineFrom(map, walk, t, &open));
  }
  return sets;
}

SurfacePoint PointOf(const SurfaceMap& map, const EdgePoint& place, int32_t triangle) {
  SurfacePoint point{triangle, Eigen::Vector3d::Zero()};
  const auto& corners = map.mesh().triangles[triangle];
  for (int k = 0; k < 3; ++k) {
    if (corners[k] == place.low) point.weights[k] = 1 - place.share;
    if (corners[k] == place.high) point.weights[k] = place.share;
  }
  return point;
}

}  // namespace slicefarm::texture
