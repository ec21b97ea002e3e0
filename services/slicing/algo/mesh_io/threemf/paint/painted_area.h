#pragma once

#include <array>
#include <cstdint>

#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing::threemf {

/// Area of a mesh painted with one state: pieces of its triangles, which form a separate surface.
struct PaintedArea {
  int64_t triangles = 0;
  /// triangles of the area; empty if meshes are not kept, and after they are moved to a package
  RawMesh mesh;
  int32_t number = -1;  ///< index of the mesh in its package; -1: not in a package yet, or no mesh
};

/// Areas where a feature is enforced, and areas where it is blocked.
struct MarkPaint {
  PaintedArea enforcers, blockers;
};

/// Paint that affects planning.
struct MeshPaint {
  MarkPaint seams, supports;

  /// Returns all four areas, in the order of their meshes in a package.
  std::array<PaintedArea*, 4> Areas() {
    return {&seams.enforcers, &seams.blockers, &supports.enforcers, &supports.blockers};
  }
};

}  // namespace slicefarm::slicing::threemf
