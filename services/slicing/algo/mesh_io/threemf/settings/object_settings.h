#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package/resource_id.h"

namespace slicefarm::slicing::threemf {

/// Slicer settings of a part. The part is a range of an object's triangles (PrusaSlicer) or one of
/// its components (Bambu Studio, OrcaSlicer).
struct PartSettings {
  std::string name;
  PartRole role = PartRole::kSolid;
  int64_t first_triangle = 0;  ///< range of triangles with `last_triangle`, in files of PrusaSlicer
  int64_t last_triangle = -1;
  ResourceId component = 0;  ///< component id, in files of Bambu Studio and OrcaSlicer
  std::vector<Setting> settings;
  int64_t line = 0;
};

/// Slicer settings of an object.
struct ObjectSettings {
  ResourceId object = 0;  ///< id of the object in the model file with the build items
  std::string name;
  std::vector<PartSettings> parts;
  std::vector<Setting> settings;
};

/// Slicer settings of a plate.
struct PlateSettings {
  struct Member {
    ResourceId object = 0;
    int64_t instance = 0;  ///< index of the instance among the build items of its object
  };
  int64_t number = 0;  ///< number of the plate, from 1
  std::string name;
  std::vector<Member> members;
  std::vector<Setting> settings;
  bool locked = false;
};

/// Slicer settings of objects and plates that are stored beside the model.
struct ModelSettings {
  std::string part;  ///< name of the file with these settings
  std::vector<ObjectSettings> objects;
  std::vector<PlateSettings> plates;
  bool has_scripts = false;  ///< true if post_process was not empty; its scripts are dropped

  /// Returns the settings of an object, or nullptr if it has none.
  const ObjectSettings* Of(ResourceId object) const;
};

/// Reads Metadata/Slic3r_PE_model.config or Metadata/model_settings.config. They have the same
/// format except for the names of a few elements. `part`: name of this file in the archive, for
/// error messages.
///
/// In PrusaSlicer's files, triangles are already in object coordinates. Therefore the matrix of a
/// volume is not applied; it only documents the origin of the triangles. Errors: any error of
/// XmlParser or AddSetting; MESH_MALFORMED for invalid numbers; MESH_TOO_LARGE above the limits
/// (limits.h) on parts, plates, and copies on plates.
absl::StatusOr<ModelSettings> ReadModelSettings(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
