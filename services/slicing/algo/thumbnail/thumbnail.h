#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/point.h"
#include "common/geometry/polygon.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Mesh that is drawn once at each of `centers`.
struct SceneMesh {
  const IndexedMesh* mesh = nullptr;
  std::span<const Point> centers;
  /// true if the mesh is closed and correctly oriented; faces that point away are then not drawn
  bool solid = false;
  int32_t first_copy = 0;  ///< number in the job of the copy at the first of `centers`
};

/// Draws the objects on a transparent background, in the view of `size.role`. The isometric view is
/// from the front, right and above, with all three axes equally foreshortened, and is scaled to
/// fill the picture. The view from above shows the box around `bed`, or the objects if there is no
/// bed. Both sides of a face are drawn, so an open mesh shows its inside.
///
/// Every pixel is the mean of several samples of a depth buffer. Among faces at the same depth the
/// brightest one is shown, so the order of the triangles does not matter. The same input gives the
/// same bytes on every machine: no sine, no threads. A mesh is drawn once and stamped at its other
/// positions, rounded to a whole sample. A picture of the role kPick has one sample per pixel,
/// because a mean of ids has no meaning.
///
/// Errors: SETTING_OUT_OF_RANGE for a size outside [1, 2048]; Cancelled. Cost: O(triangles +
/// samples of all copies).
absl::StatusOr<Thumbnail> RenderThumbnail(std::span<const SceneMesh> scene, const Polygon& bed,
                                          const ThumbnailSize& size, const CancelToken& cancel);

}  // namespace slicefarm::slicing
