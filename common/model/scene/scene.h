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

/// Value of MeshRef::mesh for a file that must have exactly one mesh, like STL, OBJ and PLY files.
inline constexpr int32_t kOnlyMesh = -1;

/// Reference to one of the meshes of a file, or to some of its triangles.
struct MeshRef {
  int32_t file = 0;
  int32_t mesh = 0;            ///< index of the mesh in the order of the file, from 0; or kOnlyMesh
  int64_t first_triangle = 0;  ///< first triangle in the order of the file
  int64_t triangle_count = -1;  ///< number of triangles; -1: all from first_triangle

  friend bool operator==(const MeshRef&, const MeshRef&) = default;
};

/// Mesh that is a part of an object.
struct Part {
  std::string name;
  MeshRef mesh;
  PartRole role = PartRole::kSolid;
  Transform to_object = Transform::Identity();
  std::vector<Setting> settings;

  bool operator==(const Part&) const = default;
};

/// Settings for a range of heights of an object, in mm above its bottom.
struct HeightRange {
  double from_mm = 0;
  double to_mm = 0;
  std::vector<Setting> settings;

  bool operator==(const HeightRange&) const = default;
};

/// Copy of an object on the plate.
struct Instance {
  Transform to_plate = Transform::Identity();
  bool printable = true;
  /// True if to_plate contains the copy's position in x and y. False: the copy is arranged
  /// automatically.
  bool placed = true;
  /// True if the position in to_plate is the position of the middle of the object's bounding box.
  /// False: it is the position of the object's origin.
  bool by_middle = false;

  bool operator==(const Instance&) const = default;
};

/// Uploaded mesh file, identified by the SHA-256 of its content. Jobs refer to this digest.
struct StoredMesh {
  std::string sha256;
  std::string name;
  MeshFormat format = MeshFormat::kUnknown;

  friend bool operator==(const StoredMesh&, const StoredMesh&) = default;
};

/// Object on the plate: its solid parts, the parts that modify them, and its copies.
struct SceneObject {
  std::string name;
  std::vector<Part> parts;  ///< parts; a later part takes precedence where parts overlap
  std::vector<HeightRange> ranges;
  std::vector<Setting> settings;
  std::vector<Instance> instances;

  bool operator==(const SceneObject&) const = default;
};

/// Makes an object of one part, from a file with one mesh. The object has one copy at each of the
/// placement's centers. Without centers, it has `copies` copies (at least one), which are arranged
/// automatically.
SceneObject ObjectOfFile(const std::string& name, int32_t file, const Placement& placement,
                         int32_t copies);

/// Plate of a project, with indices into Project::objects.
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

/// Slicer that defines the names and values of a project's settings.
enum class SettingsDialect : uint8_t {
  kPrusa,  ///< PrusaSlicer; also used for files of unknown origin
  kOrca,   ///< OrcaSlicer and Bambu Studio
};

/// Content of a project file (3MF), except the triangles of its meshes. Settings have the keys and
/// values of the file's dialect.
struct Project {
  std::string application;  ///< application that wrote the file, such as "PrusaSlicer-2.9.2"
  SettingsDialect dialect = SettingsDialect::kPrusa;
  std::vector<Setting> settings;  ///< settings of the whole project
  std::vector<SceneObject> objects;
  std::vector<ProjectPlate> plates;  ///< plates; empty: all objects are on one plate
  /// Features of the file that this service ignores, for the report, such as "painted supports of
  /// object 2".
  std::vector<std::string> without_effect;
  std::vector<int32_t> painted;  ///< indices of objects with painted filaments, ascending

  bool operator==(const Project&) const = default;
};

}  // namespace slicefarm
