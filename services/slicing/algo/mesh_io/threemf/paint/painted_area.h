#pragma once

#include <array>
#include <cstdint>

#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing::threemf {

/// Where a mesh is painted with one state: pieces of its triangles, a surface of their own.
struct PaintedArea {
  int64_t triangles = 0;
  RawMesh mesh;  ///< empty if meshes are not kept, and once a package has taken it
  int32_t number =
      -1;  ///< of the mesh among its package's; -1: it has not yet been taken, or is none
};

/// Where something is wanted on a mesh, and where not.
struct MarkPaint {
  PaintedArea enforcers, blockers;
};

/// What is planned by paint.
struct MeshPaint {
  MarkPaint seams, supports;

  /// All of them, in the order in which a package has their meshes.
  std::array<PaintedArea*, 4> Areas() {
    return {&seams.enforcers, &seams.blockers, &supports.enforcers, &supports.blockers};
  }
};

}  // namespace slicefarm::slicing::threemf
