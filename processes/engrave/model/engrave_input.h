#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "processes/engrave/model/engrave_settings.h"
#include "processes/engrave/model/surface_mesh.h"

namespace slicefarm {

/// Input of the mapping of a surface into the plane.
struct SurfaceInput {
  SurfaceMesh mesh;
  bool seam = true;  ///< true if the surface may be cut open

  friend bool operator==(const SurfaceInput&, const SurfaceInput&) = default;
};

/// Surface, cut open where necessary, with its one-to-one map into the plane.
struct MappedSurface {
  SurfaceMesh mesh;
  /// index of the vertex in the surface before the cut, per vertex of `mesh`
  std::vector<int32_t> vertex_of;
  std::vector<Eigen::Vector2d> map_mm;  ///< position of each vertex in the plane

  friend bool operator==(const MappedSurface&, const MappedSurface&) = default;
};

/// Common input of all layers of a job.
struct EngraveInput {
  EngraveSettings settings;  ///< settings without the images
  /// Object used as the texture; without triangles: the texture is not an object.
  SurfaceMesh solid;
  std::string image;  ///< PNG of the texture; empty: the texture is not an image
  std::string mask;   ///< PNG of the mask; empty: no mask
  MappedSurface surface;

  friend bool operator==(const EngraveInput&, const EngraveInput&) = default;
};

}  // namespace slicefarm
