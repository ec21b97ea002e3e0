#pragma once

#include <string>
#include <vector>

#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"

namespace slicefarm {

/// Part of an object, relative to the object's own origin.
struct PlacedScenePart {
  PartRole role = PartRole::kSolid;
  IndexedMesh mesh;
  MeshReport report;
};

/// Object in its own coordinates: the middle of its solid parts' bounding box is at x = y = 0. Its
/// bottom is at z = 0, or below if the object is sunk into the bed.
struct PlacedSceneObject {
  std::string name;
  std::vector<PlacedScenePart> parts;
  Vertex to_origin;           ///< shift that was added to all positions, in nm
  std::vector<Point> shifts;  ///< positions of the copies on the bed, in whole micrometres
};

/// Scene as placed on the bed. It is the input of processes that work on meshes.
struct PlacedScene {
  std::vector<PlacedSceneObject> objects;
};

}  // namespace slicefarm
