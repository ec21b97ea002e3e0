#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "processes/engrave/model/engrave_settings.h"
#include "processes/engrave/model/surface_mesh.h"

namespace slicefarm {

/// What a map is made of.
struct SurfaceInput {
  SurfaceMesh mesh;
  bool seam = true;  ///< whether it may be cut open

  friend bool operator==(const SurfaceInput&, const SurfaceInput&) = default;
};

/// A surface, cut open where it had to be, and its one-to-one map into the plane.
struct MappedSurface {
  SurfaceMesh mesh;
  std::vector<int32_t> vertex_of;         ///< by vertex, the one that it was before the cut
  std::vector<Eigen::Vector2d> map_mm;  ///< by vertex

  friend bool operator==(const MappedSurface&, const MappedSurface&) = default;
};

/// What all layers of a job are made of.
struct EngraveInput {
  EngraveSettings settings;  ///< without images
  SurfaceMesh solid;         ///< a texture that is an object; no triangles: it is another one
  std::string image;         ///< PNG of a texture; empty: it is none
  std::string mask;          ///< PNG; empty: none
  MappedSurface surface;

  friend bool operator==(const EngraveInput&, const EngraveInput&) = default;
};

}  // namespace slicefarm
