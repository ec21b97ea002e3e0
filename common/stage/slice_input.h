#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"

namespace slicefarm {

/// Part of an object as input of slicing. Instead of settings, it has indices into the job's tables
/// of region settings.
struct PartInput {
  std::string name;
  MeshRef mesh;
  PartRole role = PartRole::kSolid;
  Transform to_object = Transform::Identity();
  /// Indices of a solid part's region settings: one for each of ObjectInput::ranges, then one for
  /// all other heights.
  std::vector<int32_t> regions = {0};
  /// Effect of a modifier. Inside the modifier, region settings with the index `key` are replaced
  /// by region settings with the index `value`.
  std::map<int32_t, int32_t> changes = {};

  bool operator==(const PartInput&) const = default;
};

/// Range of heights above an object's bottom that has its own layer height.
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

/// Object and its copies. All copies are equal, except for their positions.
struct ObjectInput {
  std::string name;
  std::vector<PartInput> parts;
  std::vector<RangeInput> ranges;
  std::vector<CopyInput> copies = {{}};
  /// Transform that is applied after Part::to_object. Afterwards the object is moved in z so that
  /// its bottom is on the bed.
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
