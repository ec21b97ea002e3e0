#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/point.h"
#include "common/base/cancel_token.h"
#include "common/model/mesh.h"

namespace slicefarm::slicing {

/// A mesh in a picture, moved to `center`.
struct SceneMesh {
  const IndexedMesh* mesh = nullptr;
  Point center;
  bool solid = false;  ///< closed and the right side out: faces that look away need not be drawn
};

/// Draws the objects as seen from the front, right and above (isometric: all three axes equally
/// foreshortened, scaled to fill the picture), with shaded faces on a transparent ground. Both
/// sides of a face are drawn, so an open mesh shows its inside.
///
/// Every pixel is the mean of several samples of a depth buffer; of faces at the same depth the
/// brightest shows, so the order of the triangles plays no part. The same bytes for the same input
/// on every machine: no sine, no threads. Errors: SETTING_OUT_OF_RANGE for a size outside [1,
/// 2048]; Cancelled. Cost: O(triangles + samples).
absl::StatusOr<Thumbnail> RenderThumbnail(std::span<const SceneMesh> scene,
                                          const ThumbnailSize& size,
                                          const CancelToken& cancel);

}  // namespace slicefarm::slicing
