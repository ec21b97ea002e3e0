#pragma once

#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// How much of a file is wanted.
enum class ReadDepth : uint8_t {
  kStructure,  ///< the project alone: no mesh is kept
  kMeshes,     ///< and all meshes
  kNumbered,   ///< and all meshes, with the vertices of OBJ files by their numbers: none are welded
};

/// What is in a mesh file. `meshes` are those that MeshRef::mesh of the project's parts counts:
/// for STL, OBJ and PLY the only one; for 3MF those of all objects that have one, in mm, in the
/// order of the file, and after them the surfaces that are painted on them as seams and supports. Empty if only
/// the structure was read.
struct MeshFileContents {
  std::vector<RawMesh> meshes;
  Project project;
};

}  // namespace slicefarm::slicing
