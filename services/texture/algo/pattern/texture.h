#pragma once

#include <Eigen/Core>

#include "absl/status/statusor.h"
#include "services/texture/algo/pattern/height_grid.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Texture: a solid on a rectangle of the x-y plane that begins at the origin and may be repeated.
struct Texture {
  Eigen::Vector2d tile_mm = Eigen::Vector2d::Zero();
  double height_mm = 0;
  /// mesh of the solid; closed, except that its lower face may be missing, which no layer cuts
  SurfaceMesh solid;
  HeightGrid heights;  ///< heights of the solid's upper side
};

/// Returns the texture with the solid between z = 0 and the heights. Errors: NOTHING_TO_PRINT if
/// all heights are 0.
absl::StatusOr<Texture> TextureOf(HeightGrid heights);

/// Returns the texture of a solid given as a mesh, moved so that its bounding box begins at the
/// origin. `pitch_mm`: distance between repetitions; 0: the size of the box. Errors: MESH_EMPTY;
/// MESH_NOT_FINITE; MESH_MALFORMED for indices beyond the points; NOTHING_TO_PRINT for a solid
/// without height or area; SETTING_OUT_OF_RANGE for a pitch smaller than the box.
absl::StatusOr<Texture> TextureOf(SurfaceMesh solid, const Eigen::Vector2d& pitch_mm);

}  // namespace slicefarm::texture
