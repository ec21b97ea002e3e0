#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/orientation_advice.h"
#include "common/model/scene/placed_scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stage_call.h"
#include "processes/engrave/model/surface_mesh.h"

namespace slicefarm {

/// A copy as it stands on the plate.
struct PlacedCopy {
  int32_t object = 0;
  Point shift;        ///< shift of the object's origin, in whole micrometres
  Polygon footprint;  ///< the object's convex hull at its place; no points: no area

  friend bool operator==(const PlacedCopy&, const PlacedCopy&) = default;
};

/// Layers bottom up without gaps (a layer may be empty), and findings about the meshes.
struct SlicedJob {
  std::vector<SlicedLayer> layers;
  std::vector<std::string> object_names;  ///< name of each object
  std::vector<PlacedCopy> copies;         ///< copies, ordered by object and then as in the input
  std::vector<MeshReport> meshes;         ///< one a part, by object; none of surfaces for seams
  std::vector<Thumbnail> thumbnails;
  std::vector<OrientationAdvice>
      orientations;  ///< advice for objects that would print better in another orientation
};

/// Outlines of a sliced job and its copies.
struct SlicedOutlines {
  std::span<const SlicedLayer> layers;
  std::span<const PlacedCopy> copies;
  std::span<const std::string> object_names =
      {};  ///< names for messages; may be fewer than objects
};

class SlicingStage {
 public:
  virtual ~SlicingStage() = default;
  /// Takes the input by value: the bytes of a big mesh are freed as soon as they are read.
  virtual absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                          const SlicingOptions& options) const = 0;
};

/// Reads meshes and puts them on the bed, for processes that work on the meshes themselves. Errors:
/// those of slicing up to there.
class PlacingStage {
 public:
  virtual ~PlacingStage() = default;
  virtual absl::StatusOr<PlacedScene> Place(const StageCall& call, SliceInput input,
                                            const SlicingOptions& options) const = 0;
  /// The objects as their files have them, transformed and not placed: for processes that need the
  /// doubles. Errors: REQUEST_MALFORMED for an object that is not one part and one copy;
  /// MESH_TOO_LARGE.
  virtual absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const = 0;
};

}  // namespace slicefarm
