#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/map/tutte.h"
#include "services/texture/algo/surface/disk.h"

namespace slicefarm::texture {

/// Triangles around a flat map: between the map's boundary and a frame (frame.h), and in the map's
/// holes. The map does not overlap itself as long as no shell triangle flips and the frame does not
/// cross itself. The shell is built once and deforms with the map.
struct Shell {
  /// points of the shell; their indices follow the indices of the map's points
  std::vector<Eigen::Vector2d> points;
  std::vector<std::array<int32_t, 3>> triangles;  ///< counter-clockwise
  std::vector<int32_t> frame;                     ///< outermost points, counter-clockwise
};

/// Returns the shell of `map`. The map's outer loop is on a circle around the origin. Between this
/// loop and the frame, the shell has rings of points around the origin, with fewer points from ring
/// to ring. In each hole, the shell is a fan of triangles. Errors: INTERNAL if a loop does not have
/// the form that Tutte's embedding gives it. Source: Su, Ye, Liu, Fu, "Efficient Bijective
/// Parameterizations", ACM TOG 39 (2020).
absl::StatusOr<Shell> ShellAround(const FirstMap& map, std::span<const BoundaryLoop> loops);

}  // namespace slicefarm::texture
