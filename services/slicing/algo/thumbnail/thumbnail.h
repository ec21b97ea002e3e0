#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/point.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// A mesh in a picture, once at each of `centers`.
struct SceneMesh {
  const IndexedMesh* mesh = nullptr;
  std::span<const Point> centers;
  bool solid = false;  ///< closed and the right side out: faces that look away need not be drawn
};

/// Draws the objects as seen from the front, right and above (isometric: all three axes equally
/// foreshortened, scaled to fill the picture), with shaded faces on a transparent ground. Both
/// sides of a face are drawn, so an open mesh shows its inside.
///
/// Every pixel is the mean of several samples of a depth buffer; of faces at the same depth the
/// brightest shows, so the order of the triangles plays no part. The same bytes for the same input
/// on every machine: no sine, no threads. A mesh is drawn once and stamped at its other places, to
/// a whole sample. Errors: SETTING_OUT_OF_RANGE for a size outside [1, 2048]; Cancelled. Cost:
/// O(triangles + samples of all copies).
absl::StatusOr<Thumbnail> RenderThumbnail(std::span<const SceneMesh> scene,
                                          const ThumbnailSize& size,
                                          const CancelToken& cancel);

}  // namespace slicefarm::slicing
