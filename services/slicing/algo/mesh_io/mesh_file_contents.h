#pragma once

#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Part of a mesh file that a reader returns.
enum class ReadDepth : uint8_t {
  kStructure,  ///< the project only, without meshes
  kMeshes,     ///< the project and all meshes
  kNumbered,   ///< the project and all meshes; OBJ vertices keep their numbers and are not welded
};

/// Contents of a mesh file. MeshRef::mesh of the project's parts is an index into `meshes`.
///
/// STL, OBJ and PLY files have one mesh. In a 3MF, an object may have a mesh of its own. `meshes`
/// first contains these meshes, in mm and in the order of the file. After them it contains the
/// surfaces painted as seams and supports. `meshes` is empty if only the structure was read.
struct MeshFileContents {
  std::vector<RawMesh> meshes;
  Project project;
};

}  // namespace slicefarm::slicing
