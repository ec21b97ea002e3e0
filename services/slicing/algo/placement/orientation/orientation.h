#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Options for suggesting orientations.
struct OrientationOptions {
  /// Overhang angle in degrees, in [0, 90]. A face that points down needs support if its angle to
  /// the horizontal is smaller by 0.1 degrees or more.
  double overhang_deg = 45;
  size_t suggestions = 3;  ///< largest number of suggestions besides the current orientation
};

/// Orientation for printing an object, with its areas and score.
struct PrintOrientation {
  /// rotation from the given mesh to this orientation
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double footprint_mm2 = 0;  ///< area of the convex hull seen from above
  double contact_mm2 = 0;    ///< area of the faces on the bed (within 0.05 mm)
  double overhang_mm2 = 0;   ///< area of the faces that need support, seen from above
  double height_mm = 0;
  bool stable = false;  ///< true if the centre of mass is above the hull of the faces on the bed
  double score = 0;     ///< score; smaller is better
};

/// Result of SuggestOrientation.
struct OrientationSuggestion {
  PrintOrientation current;
  std::vector<PrintOrientation> best;  ///< stable orientations, best first; may be empty
};

/// Suggests orientations in which the object rests on a large face and needs little support.
///
/// Candidates are the planes of the convex hull's faces and of the mesh's largest faces. Planes
/// within 1 degree of each other count as one. At most 40 planes are used, the ones of the largest
/// area. The current orientation is a candidate too. For each candidate, the object is rotated by
/// the smallest angle that makes the plane point down. With S the area of the convex hull's
/// surface,
///   score = (overhang - contact / 4) / S + height / (4 sqrt(S)),  plus 1 if not stable.
///
/// So 1 mm2 less overhang is worth 4 mm2 more contact. Of two orientations without overhang, the
/// lower one wins unless its contact area is much smaller. `best` may begin with the current
/// orientation.
///
/// For a mesh that encloses no volume, the centre of mass of its surface is used. The result is
/// deterministic. The object is not moved; the caller drops the result onto z = 0.
///
/// Errors: MESH_EMPTY if no triangle has an area; SETTING_OUT_OF_RANGE for invalid angles;
/// CANCELLED. REQUIRES: triangles name existing vertices, within 10 m.
///
/// Cost: O(n) for each of the at most 40 candidates. On one core: 0.9 s for a million triangles,
/// 0.25 s for benchy's 225,154.
///
/// Source: candidates and the three measures as in C. Schranz, "Tweaker - Auto Rotation Module for
/// FDM 3D Printing" (2016); the weights were chosen for this project.
absl::StatusOr<OrientationSuggestion> SuggestOrientation(const IndexedMesh& mesh,
                                                         const OrientationOptions& options,
                                                         const CancelToken& cancel);

/// Returns the angles for Placement::rotate_deg (about x, then y, then z) that give this rotation,
/// rounded to 1e-6 degrees.
std::array<double, 3> AnglesXyzDegrees(const Eigen::Matrix3d& rotation);

}  // namespace slicefarm::slicing
