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

/// Copy at its position on the plate.
struct PlacedCopy {
  int32_t object = 0;
  Point shift;        ///< shift of the object's origin, in whole micrometres
  Polygon footprint;  ///< convex hull of the object at its position; empty: no area

  friend bool operator==(const PlacedCopy&, const PlacedCopy&) = default;
};

/// Result of slicing: layers from the bottom up without gaps (a layer may be empty), and properties
/// of the meshes.
struct SlicedJob {
  std::vector<SlicedLayer> layers;
  std::vector<std::string> object_names;  ///< name of each object
  /// copies, sorted by object; copies of one object are in the input's order
  std::vector<PlacedCopy> copies;
  /// report of each part, sorted by object; seam enforcers and blockers made of surfaces have no
  /// report
  std::vector<MeshReport> meshes;
  std::vector<Thumbnail> thumbnails;
  std::vector<OrientationAdvice>
      orientations;  ///< advice for objects that would print better in another orientation
};

/// Outlines of a sliced job and its copies.
struct SlicedOutlines {
  std::span<const SlicedLayer> layers;
  std::span<const PlacedCopy> copies;
  std::span<const std::string> object_names =
      {};  ///< names of the objects for messages; the list may be shorter than the list of objects
};

/// Stage that reads meshes, puts them on the bed and slices them.
class SlicingStage {
 public:
  virtual ~SlicingStage() = default;
  /// Slices the objects. `input` is passed by value, so that the bytes of a large mesh are freed as
  /// soon as the mesh is read.
  virtual absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                          const SlicingOptions& options) const = 0;
};

/// Stage that reads meshes and puts them on the bed, for processes that work on the meshes
/// themselves. Errors: any error of SlicingStage that concerns reading or placing meshes.
class PlacingStage {
 public:
  virtual ~PlacingStage() = default;
  virtual absl::StatusOr<PlacedScene> Place(const StageCall& call, SliceInput input,
                                            const SlicingOptions& options) const = 0;
  /// Returns the objects with the double-precision coordinates of their files, transformed but not
  /// placed on the bed. Errors: REQUEST_MALFORMED for an object that is not one part and one copy;
  /// MESH_TOO_LARGE above limits::kMaxSurfaceTriangles or kMaxSurfacePoints, or for a transformed
  /// point beyond kMaxMeshCoordinateMm.
  virtual absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const = 0;
};

}  // namespace slicefarm
