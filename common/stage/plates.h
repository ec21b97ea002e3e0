#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/slicing_options.h"
#include "common/model/scene/scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Position of a copy when a scene is distributed over several plates.
struct PlatePosition {
  int32_t plate = 0;
  Point middle;  ///< position on the plate of the middle of the object's bounding box
  /// True if the copy is turned by 90 degrees about the vertical, counter-clockwise.
  bool turned = false;

  friend bool operator==(const PlatePosition&, const PlatePosition&) = default;
};

/// Stage that distributes a scene over as many plates as necessary, before jobs are made from the
/// scene. The stage is pure and thread-safe, like the stages of jobs (stages.h).
class ArrangingStage {
 public:
  virtual ~ArrangingStage() = default;

  /// Returns a position for each copy, in the order of the objects. A copy that has a position
  /// already keeps it, on plate 0. Each other copy gets a position on some plate. A copy is turned
  /// only if this saves a plate. Errors: OUT_OF_BUILD_VOLUME with the objects that are too large
  /// for an empty bed; any error of reading the meshes (SlicingStage); Cancelled.
  virtual absl::StatusOr<std::vector<PlatePosition>> PutOnPlates(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const = 0;
};

/// Returns the input of PutOnPlates for a scene. Printable copies of an object with different
/// orientations become separate objects. The parts have no region settings.
std::vector<ObjectInput> ObjectsToArrange(std::span<const SceneObject> objects);

/// Returns the objects of each plate, with the copies that are on this plate. No plate is empty,
/// and objects keep their order. `positions`: one for each copy of ObjectsToArrange(objects), in
/// the same order.
std::vector<std::vector<SceneObject>> OnPlates(std::span<const SceneObject> objects,
                                               std::span<const PlatePosition> positions);

}  // namespace slicefarm
