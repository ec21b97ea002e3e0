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

/// Where a copy goes when a scene is put on several plates.
struct PlatePlace {
  int32_t plate = 0;
  Point middle;         ///< where the middle of the object's box stands on that plate
  bool turned = false;  ///< by a quarter turn about the vertical, counter-clockwise

  friend bool operator==(const PlatePlace&, const PlatePlace&) = default;
};

/// Puts what does not fit on one bed on as many as it takes, before it is made into jobs. Pure and
/// thread-safe, as the stages of jobs are.
class ArrangingStage {
 public:
  virtual ~ArrangingStage() = default;

  /// A place for each copy, by object. Copies with a place keep it, on plate 0; each other one gets
  /// one on some plate. Copies are turned only where that saves a plate. Errors: what Reason lists;
  /// OUT_OF_BUILD_VOLUME naming objects that are too large for an empty bed; Cancelled.
  virtual absl::StatusOr<std::vector<PlatePlace>> PutOnPlates(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const = 0;
};

/// A scene as that stage is given it: an object for each way in which printable copies of one are
/// turned. Its parts have no rows of settings.
std::vector<ObjectInput> ObjectsToPlace(std::span<const SceneObject> objects);

/// The scene on plates, each with the copies that it has; none is empty, and objects keep their
/// order. `places`: one for each copy of ObjectsToPlace(objects).
std::vector<std::vector<SceneObject>> OnPlates(std::span<const SceneObject> objects,
                                               std::span<const PlatePlace> places);

}  // namespace slicefarm
