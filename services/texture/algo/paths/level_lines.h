#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// A place on an edge: between vertices of the opened mesh, the lower number first.
struct EdgePlace {
  int32_t low = 0;
  int32_t high = 0;
  double share = 0;  ///< of the way from low to high
};

/// A way through triangles, from edge to edge: places.size() == triangles.size() + 1. A closed one
/// ends where it began.
struct LevelLine {
  std::vector<EdgePlace> places;
  std::vector<int32_t> triangles;

  bool closed() const {
    return places.front().low == places.back().low && places.front().high == places.back().high;
  }
};

/// Lines where a field that is linear on triangles has given values: all lines of a level together.
/// The field grows to the left of a line. Vertices at a level count as above it, so that a line
/// passes from triangle to triangle whatever it meets.
struct LevelSet {
  std::vector<LevelLine> lines;
};

/// `field`: by vertex of the map's mesh. `levels` ascend. Lines of a level are ordered by their
/// first triangle. Errors: Cancelled. Cost: O(t log t + steps) for t triangles.
absl::StatusOr<std::vector<LevelSet>> LevelLines(const SurfaceMap& map,
                                                 std::span<const double> field,
                                                 std::span<const double> levels,
                                                 const CancelToken& cancel = {});

/// A place on an edge as a point of a triangle that has the edge.
SurfacePoint PointOf(const SurfaceMap& map, const EdgePlace& place, int32_t triangle);

}  // namespace slicefarm::texture
