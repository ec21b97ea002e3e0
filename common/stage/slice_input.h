#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"

namespace slicefarm {

/// A part of an object as slicing sees it: its settings are rows of the job's tables by now.
struct PartInput {
  std::string name;
  MeshRef mesh;
  PartRole role = PartRole::kSolid;
  Transform to_object = Transform::Identity();
  /// Rows of a solid part's regions: one for each of ObjectInput::ranges, then the row of all other
  /// heights.
  std::vector<int32_t> regions = {0};
  /// Rows of regions inside a modifier, by the row that the region has outside of it.
  std::map<int32_t, int32_t> changes = {};

  bool operator==(const PartInput&) const = default;
};

/// Heights of an object, above its bottom, with a layer height of their own.
struct RangeInput {
  Coord from_nm = 0;
  Coord to_nm = 0;
  Coord layer_height_nm = 0;

  friend bool operator==(const RangeInput&, const RangeInput&) = default;
};

/// Place of a copy.
struct CopyInput {
  enum class Place : uint8_t {
    kAnywhere,  ///< to be arranged; alone on the plate: in the middle of the bed
    kMiddleAt,  ///< the middle of the object's box is over `at`
    kOriginAt,  ///< the object's origin is over `at`
  };
  Place place = Place::kAnywhere;
  Point at;

  friend bool operator==(const CopyInput&, const CopyInput&) = default;
};

/// An object and its copies, which are all alike.
struct ObjectInput {
  std::string name;
  std::vector<PartInput> parts;
  std::vector<RangeInput> ranges;
  std::vector<CopyInput> copies = {{}};
  /// Put before each part's to_object. Afterwards the object is lowered or raised until it stands
  /// on the bed.
  Transform to_plate = Transform::Identity();
  /// Depth of the object below the bed, mm; that part is not printed.
  double sunk_mm = 0;

  bool operator==(const ObjectInput&) const = default;
};

struct SliceInput {
  std::vector<MeshFile> files;
  std::vector<ObjectInput> objects;
  bool advise_orientations = false;  ///< whether SlicedJob::orientations is wanted
};

}  // namespace slicefarm
