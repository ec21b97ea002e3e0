#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Line over a surface in a picture.
struct PictureLine {
  Eigen::Vector3d from_mm;
  Eigen::Vector3d to_mm;
  /// normal of the surface at the line; lines on the far side of the surface are left out
  Eigen::Vector3d normal;
  double shade = 0;  ///< 0 to 1 on the colour scale
};

/// Options for DrawSurface.
struct SurfacePictureOptions {
  int size_px = 1200;  ///< size of the longer side
  Eigen::Vector3d towards_viewer = {0.45, -0.65, 0.61};
};

/// Draws a shaded surface with lines on it, without perspective. Triangles are drawn from far to
/// near. Returns a PNG. Errors: Internal if the picture cannot be made. Cost: O(n log n) for n
/// triangles and lines.
absl::StatusOr<std::string> DrawSurface(const SurfaceMesh& mesh, std::span<const PictureLine> lines,
                                        const SurfacePictureOptions& options);

/// Draws the triangles of a flat map. `values`: one value per triangle, which selects its colour
/// from 1 (dark) to `most` (light). Returns a PNG.
absl::StatusOr<std::string> DrawMap(const SurfaceMesh& mesh,
                                    std::span<const Eigen::Vector2d> map_mm,
                                    std::span<const double> values, double most, int size_px);

}  // namespace slicefarm::texture
