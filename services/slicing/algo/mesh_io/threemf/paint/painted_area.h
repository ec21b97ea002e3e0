#pragma once

#include <array>
#include <cstdint>

#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing::threemf {

/// Area of a mesh painted with one state, as a separate surface. It consists of pieces of the
/// mesh's triangles.
struct PaintedArea {
  int64_t triangles = 0;
  /// triangles of the area; empty if meshes are not requested, or after the move to Package::meshes
  RawMesh mesh;
  int32_t number = -1;  ///< index in Package::meshes; -1: not moved there yet, or no mesh
};

/// Areas where a feature is enforced, and areas where it is blocked.
struct MarkPaint {
  PaintedArea enforcers, blockers;
};

/// Painted marks that affect planning: seams and supports.
struct MeshPaint {
  MarkPaint seams, supports;

  /// Returns all four areas, in the order of their meshes in a package.
  std::array<PaintedArea*, 4> Areas() {
    return {&seams.enforcers, &seams.blockers, &supports.enforcers, &supports.blockers};
  }
};

}  // namespace slicefarm::slicing::threemf
