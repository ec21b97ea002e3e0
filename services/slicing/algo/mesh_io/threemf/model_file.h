#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package/resource_id.h"
#include "services/slicing/algo/mesh_io/threemf/paint/painted_area.h"

namespace slicefarm::slicing::threemf {

/// Reference to an object of this or another model file, with the transform of the object.
struct ObjectUse {
  std::string path;  ///< path of the model file; empty: the file that contains this use
  ResourceId object = 0;
  Transform transform = Transform::Identity();  ///< transform, in mm
  int64_t line = 0;
};

/// Element `item`: reference to an object that is to be printed.
struct BuildItem : ObjectUse {
  bool printable = true;
};

/// Object as a model file defines it: with a mesh, with components, or empty.
struct ObjectResource {
  ResourceId id = 0;
  std::string name;
  std::string type = "model";
  /// index of the object's mesh among all meshes of all model files; -1: no mesh
  int32_t mesh = -1;
  int64_t triangles = 0;
  uint8_t paint = 0;  ///< flags of Paint
  MeshPaint marks;
  bool coloured = false;
  std::vector<ObjectUse> components;
  int64_t line = 0;
};

/// Model file of the archive: the objects that it defines.
struct ModelFile {
  std::string part;
  double unit_mm = 1;
  std::string application;
  std::vector<ObjectResource> objects;
  std::map<ResourceId, size_t> by_id;  ///< object id -> index into `objects`
  std::vector<BuildItem> items;
};

}  // namespace slicefarm::slicing::threemf
