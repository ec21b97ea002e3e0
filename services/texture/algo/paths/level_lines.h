#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Point on an edge between two vertices of the opened mesh (cut_open.h). `low` is the vertex with
/// the lower index.
struct EdgePoint {
  int32_t low = 0;
  int32_t high = 0;
  double share = 0;  ///< relative position of the point, from 0 at `low` to 1 at `high`
};

/// Line over the surface. It crosses `triangles` one after the other and passes from each to the
/// next at one of `points`. points.size() == triangles.size() + 1. A closed line ends at its first
/// point.
struct LevelLine {
  std::vector<EdgePoint> points;
  std::vector<int32_t> triangles;

  /// Returns true if the line is closed.
  bool closed() const {
    return points.front().low == points.back().low && points.front().high == points.back().high;
  }
};

/// All lines of one level. The lines are the points where a field has a given value; the field is
/// linear on each triangle. It increases to the left of a line. Vertices at the level count as
/// above it, so a line always continues from triangle to triangle.
struct LevelSet {
  std::vector<LevelLine> lines;
};

/// Returns the lines of all levels. `field`: value per vertex of the map's mesh. `levels`:
/// ascending values. The lines of a level are sorted by their first triangle. Errors: Cancelled.
/// Cost: O(t log t) for t triangles, plus O(triangles that the lines pass).
absl::StatusOr<std::vector<LevelSet>> LevelLines(const SurfaceMap& map,
                                                 std::span<const double> field,
                                                 std::span<const double> levels,
                                                 const CancelToken& cancel = {});

/// Returns a point on an edge in the coordinates of a triangle. REQUIRES: `triangle` has this edge.
SurfacePoint PointOf(const SurfaceMap& map, const EdgePoint& place, int32_t triangle);

}  // namespace slicefarm::texture
