#pragma once

#include <string>
#include <vector>

#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"

namespace slicefarm {

/// A part of an object, around the object's own origin.
struct PlacedScenePart {
  PartRole role = PartRole::kSolid;
  IndexedMesh mesh;
  MeshReport report;
};

/// An object whose solid parts' box has its middle over x = y = 0, and its bottom at z = 0 or as
/// far below as it is sunk.
struct PlacedSceneObject {
  std::string name;
  std::vector<PlacedScenePart> parts;
  Vertex to_origin;           ///< what was added to all its places, in nm
  std::vector<Point> shifts;  ///< of its copies on the bed, in whole micrometres
};

/// A scene as it stands on the bed: what processes begin with that work on meshes.
struct PlacedScene {
  std::vector<PlacedSceneObject> objects;
};

}  // namespace slicefarm
