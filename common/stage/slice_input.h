#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"

namespace slicefarm {

/// Part of an object as input of slicing. Its settings are indexes into the job's tables of region
/// settings.
struct PartInput {
  std::string name;
  MeshRef mesh;
  PartRole role = PartRole::kSolid;
  Transform to_object = Transform::Identity();
  /// Region settings of a solid part: one index for each of ObjectInput::ranges, then the index for
  /// all other heights.
  std::vector<int32_t> regions = {0};
  /// Effect of a modifier: for the index of the region settings outside of the modifier, the index
  /// of the settings inside it.
  std::map<int32_t, int32_t> changes = {};

  bool operator==(const PartInput&) const = default;
};

/// Heights of an object, above its bottom, that have a layer height of their own.
struct RangeInput {
  Coord from_nm = 0;
  Coord to_nm = 0;
  Coord layer_height_nm = 0;

  friend bool operator==(const RangeInput&, const RangeInput&) = default;
};

/// Position of a copy.
struct CopyInput {
  enum class Place : uint8_t {
    kAnywhere,  ///< automatic arrangement; a copy alone on the plate is in the middle of the bed
    kMiddleAt,  ///< middle of the object's bounding box at `at`
    kOriginAt,  ///< origin of the object at `at`
  };
  Place place = Place::kAnywhere;
  Point at;

  friend bool operator==(const CopyInput&, const CopyInput&) = default;
};

/// Object and its copies, which are all alike.
struct ObjectInput {
  std::string name;
  std::vector<PartInput> parts;
  std::vector<RangeInput> ranges;
  std::vector<CopyInput> copies = {{}};
  /// Transform that is applied after each part's to_object. Afterwards the object is lowered or
  /// raised onto the bed.
  Transform to_plate = Transform::Identity();
  /// Depth to which the object is sunk into the bed, in mm. The part of the object below the bed is
  /// not printed.
  double sunk_mm = 0;

  bool operator==(const ObjectInput&) const = default;
};

/// Input of slicing: mesh files and the objects that use them.
struct SliceInput {
  std::vector<MeshFile> files;
  std::vector<ObjectInput> objects;
  bool advise_orientations = false;  ///< true: computes SlicedJob::orientations
};

}  // namespace slicefarm
