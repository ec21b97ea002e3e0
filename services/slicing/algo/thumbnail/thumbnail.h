#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Mesh that is drawn once at each of `centers`.
struct SceneMesh {
  const IndexedMesh* mesh = nullptr;
  std::span<const Point> centers;
  /// true if the mesh is closed and correctly oriented; faces that point away are then not drawn
  bool solid = false;
};

/// Draws the objects as seen from the front, right and above, with shaded faces on a transparent
/// background. The view is isometric (all three axes are equally foreshortened) and scaled to fill
/// the picture. Both sides of a face are drawn, so an open mesh shows its inside.
///
/// Every pixel is the mean of several samples of a depth buffer. Among faces at the same depth the
/// brightest one is shown, so the order of the triangles does not matter. The same input gives the
/// same bytes on every machine: no sine, no threads. A mesh is rendered once. The image is copied
/// to its other positions, rounded to whole samples.
///
/// Errors: SETTING_OUT_OF_RANGE for a size outside [1, 2048]; Cancelled. Cost: O(triangles +
/// samples of all copies).
absl::StatusOr<Thumbnail> RenderThumbnail(std::span<const SceneMesh> scene,
                                          const ThumbnailSize& size, const CancelToken& cancel);

}  // namespace slicefarm::slicing
