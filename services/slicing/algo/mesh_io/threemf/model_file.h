#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package/resource_id.h"
#include "services/slicing/algo/mesh_io/threemf/paint/painted_area.h"

namespace slicefarm::slicing::threemf {

/// An object of a model file, or of another one, and how it is moved.
struct ObjectUse {
  std::string path;  ///< the model file; empty: the one that says so
  ResourceId object = 0;
  Transform transform = Transform::Identity();  ///< in mm
  int64_t line = 0;
};

struct BuildItem : ObjectUse {
  bool printable = true;
};

/// An object as a model file defines it: a mesh, or components, or nothing.
struct ObjectResource {
  ResourceId id = 0;
  std::string name;
  std::string type = "model";
  int32_t mesh = -1;  ///< by the order of all meshes of all model files; -1: it has none
  int64_t triangles = 0;
  uint8_t paint = 0;  ///< Paint flags
  MeshPaint marks;
  bool coloured = false;
  std::vector<ObjectUse> components;
  int64_t line = 0;
};

/// One file of the archive that defines objects.
struct ModelFile {
  std::string part;
  double unit_mm = 1;
  std::string application;
  std::vector<ObjectResource> objects;
  std::map<ResourceId, size_t> by_id;  ///< index into objects
  std::vector<BuildItem> items;
};

}  // namespace slicefarm::slicing::threemf
