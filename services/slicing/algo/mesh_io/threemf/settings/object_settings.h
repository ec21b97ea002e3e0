#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package/resource_id.h"

namespace slicefarm::slicing::threemf {

/// What a slicer says of a part: of a range of an object's triangles (PrusaSlicer), or of one of
/// its components (Bambu Studio, OrcaSlicer).
struct PartSettings {
  std::string name;
  PartRole role = PartRole::kSolid;
  int64_t first_triangle = 0;  ///< PrusaSlicer's, as is the next
  int64_t last_triangle = -1;
  ResourceId component = 0;  ///< the others'
  std::vector<Setting> settings;
  int64_t line = 0;
};

struct ObjectSettings {
  ResourceId object = 0;  ///< of the model that says what to build
  std::string name;
  std::vector<PartSettings> parts;
  std::vector<Setting> settings;
};

struct PlateSettings {
  struct Member {
    ResourceId object = 0;
    int64_t instance = 0;  ///< which of the object's build items
  };
  int64_t number = 0;  ///< from 1
  std::string name;
  std::vector<Member> members;
  std::vector<Setting> settings;
  bool locked = false;
};

/// What slicers say of objects and plates besides the model.
struct ModelSettings {
  std::string part;  ///< that says so
  std::vector<ObjectSettings> objects;
  std::vector<PlateSettings> plates;
  bool has_scripts = false;  ///< post_process, which is never read

  const ObjectSettings* Of(ResourceId object) const;
};

/// Reads Metadata/Slic3r_PE_model.config or Metadata/model_settings.config: the same document but
/// for the names of a few elements. Triangles in PrusaSlicer's files lie in the object as they are:
/// the matrix of a volume only says how they came there.
/// Errors: those of XmlParser, MESH_MALFORMED for numbers that are none, MESH_TOO_LARGE.
absl::StatusOr<ModelSettings> ReadModelSettings(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
