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

/// Triangles around a flat map, between its boundary and a frame, and in its holes: as long as none
/// of them flips and the frame does not cross itself, neither does the map. Built once; it bends
/// with the map.
struct Shell {
  std::vector<Eigen::Vector2d> points;            ///< numbered on from the map's
  std::vector<std::array<int32_t, 3>> triangles;  ///< counter-clockwise
  std::vector<int32_t> frame;                     ///< the outermost points, counter-clockwise
};

/// The shell of a map whose outer loop lies on a circle around the origin: rings of ever
/// fewer points; holes are fans. Errors: INTERNAL if a loop is not what Tutte's embedding
/// makes. Source: Su, Ye, Liu, Fu, "Efficient Bijective Parameterizations", ACM TOG 39 (2020).
absl::StatusOr<Shell> ShellAround(const FirstMap& map, std::span<const BoundaryLoop> loops);

}  // namespace slicefarm::texture
