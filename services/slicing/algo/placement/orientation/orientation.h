#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

struct OrientationOptions {
  /// Faces that look down and slope less than this (by 0.1 or more) from the horizontal need
  /// support; [0, 90].
  double overhang_deg = 45;
  size_t suggestions = 3;  ///< at most this many besides the present orientation
};

/// A way round to print an object, and what speaks for and against it.
struct PrintOrientation {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< applied to the mesh as given
  double footprint_mm2 = 0;                                ///< of the convex hull seen from above
  double contact_mm2 = 0;   ///< faces that lie on the bed (within 0.05 mm)
  double overhang_mm2 = 0;  ///< faces that need support, seen from above
  double height_mm = 0;
  bool stable = false;  ///< the centre of mass is over the hull of what touches the bed
  double score = 0;     ///< least is best
};

struct OrientationSuggestion {
  PrintOrientation current;
  std::vector<PrintOrientation> best;  ///< stable ones, best first; empty if there are none
};

/// Ways to lay an object down so that a large face holds it and little needs support.
///
/// Candidates are the planes of the convex hull's faces and of the mesh's largest faces, those
/// within 1 degree of each other taken together, at most 40 by area, and the present orientation;
/// each is turned down the shortest way. With S the area of the hull,
///   score = (overhang - contact / 4) / S + height / (4 sqrt(S)),  plus 1 if not stable.
/// So 1 mm2 less overhang is worth 4 mm2 more on the bed, and of two ways without overhang the
/// lower wins unless it stands on much less. `best` may begin with the present orientation.
///
/// A mesh that encloses no volume has its centre of mass in its surface. Deterministic; does not
/// move the object: the caller drops the result onto z = 0.
///
/// Errors: MESH_EMPTY if no triangle has an area. SETTING_OUT_OF_RANGE for angles that are not.
///         CANCELLED. REQUIRES: triangles name existing vertices, within 10 m.
/// Cost:   O(n) for each of the at most 40 candidates. On one core: 0.9 s for a
///         million triangles, 0.25 s for benchy's 225,154.
/// Source: candidates and the three measures as in C. Schranz, "Tweaker - Auto Rotation Module for
///         FDM 3D Printing" (2016); the weights are ours.
absl::StatusOr<OrientationSuggestion> SuggestOrientation(const IndexedMesh& mesh,
                                                         const OrientationOptions& options,
                                                         const CancelToken& cancel);

/// Angles for Placement::rotate_deg (about x, then y, then z), in 1e-6 degrees, that give this
/// rotation.
std::array<double, 3> AnglesXyzDegrees(const Eigen::Matrix3d& rotation);

}  // namespace slicefarm::slicing
