#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/part_role.h"
#include "common/model/scene/placement.h"
#include "common/model/scene/transform.h"
#include "common/model/setting.h"

namespace slicefarm {

/// MeshRef::mesh of a file that must have no more than one, as STL, OBJ and PLY files do.
inline constexpr int32_t kOnlyMesh = -1;

/// One of the meshes of a file, or some of its triangles.
struct MeshRef {
  int32_t file = 0;
  int32_t mesh = 0;             ///< by the order in which the file has them, or kOnlyMesh
  int64_t first_triangle = 0;   ///< of the mesh as the file lists it
  int64_t triangle_count = -1;  ///< -1: all from first_triangle on

  friend bool operator==(const MeshRef&, const MeshRef&) = default;
};

/// A mesh as a part of an object.
struct Part {
  std::string name;
  MeshRef mesh;
  PartRole role = PartRole::kSolid;
  Transform to_object = Transform::Identity();
  std::vector<Setting> settings;

  bool operator==(const Part&) const = default;
};

/// Settings of a slice of an object, in mm above its bottom.
struct HeightRange {
  double from_mm = 0;
  double to_mm = 0;
  std::vector<Setting> settings;

  bool operator==(const HeightRange&) const = default;
};

/// A copy of an object on the plate.
struct Instance {
  Transform to_plate = Transform::Identity();
  bool printable = true;
  /// Whether to_plate's x and y say where it stands; else it is to be arranged.
  bool placed = true;
  /// They say where the middle of the object's box stands, and not the object's origin.
  bool by_middle = false;

  bool operator==(const Instance&) const = default;
};

/// A mesh file by its content: what jobs refer to once it was uploaded.
struct StoredMesh {
  std::string sha256;
  std::string name;
  MeshFormat format = MeshFormat::kUnknown;

  friend bool operator==(const StoredMesh&, const StoredMesh&) = default;
};

/// What stands on the plate as one: solid parts, what changes them, and its copies.
struct SceneObject {
  std::string name;
  std::vector<Part> parts;  ///< later ones win where they overlap
  std::vector<HeightRange> ranges;
  std::vector<Setting> settings;
  std::vector<Instance> instances;

  bool operator==(const SceneObject&) const = default;
};

/// An object of one part, the whole of a file with one mesh: a copy at each of the placement's
/// centers, or `copies` (one at least) wherever there is room.
SceneObject ObjectOfFile(const std::string& name, int32_t file, const Placement& placement,
                         int32_t copies);

/// One plate of a project, with indices into Project::objects.
struct ProjectPlate {
  struct Member {
    int32_t object = 0;
    int32_t instance = 0;

    friend bool operator==(const Member&, const Member&) = default;
  };
  std::string name;
  std::vector<Member> members;
  std::vector<Setting> settings;
  bool locked = false;

  bool operator==(const ProjectPlate&) const = default;
};

/// Whose names and values the settings of a project have.
enum class SettingsDialect : uint8_t {
  kPrusa,  ///< PrusaSlicer's own, and those of no slicer
  kOrca,   ///< OrcaSlicer's and Bambu Studio's
};

/// What a project file (3MF) says besides its triangles. Settings are text as the file has them,
/// under the names of its dialect.
struct Project {
  std::string application;  ///< "PrusaSlicer-2.9.2", as the file says
  SettingsDialect dialect = SettingsDialect::kPrusa;
  std::vector<Setting> settings;  ///< of the whole project
  std::vector<SceneObject> objects;
  std::vector<ProjectPlate> plates;  ///< empty: all objects lie on one
  /// What the file has and nobody here makes anything of, for the report: "painted supports of
  /// object 2".
  std::vector<std::string> without_effect;
  std::vector<int32_t> painted;  ///< indices of objects on which filaments are painted, ascending

  bool operator==(const Project&) const = default;
};

}  // namespace slicefarm
