#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// Options of the decomposition into convex pieces.
struct DecomposeOptions {
  DecomposeMethod method = DecomposeMethod::kBian;
  /// Largest distance in nm by which the removal of a corner moves the boundary. All removed
  /// corners together change the area by at most 2e-10 of it.
  double merge_nm = 1'000;
  /// Choice among cuts of nearly the same quality. 0 is the paper's choice. Other values start the
  /// search at other corners and use the second or third best ends that the rules permit.
  int32_t variant = 0;
};

/// Convex pieces that cover each point of the islands exactly once.
struct ConvexPieces {
  /// Coordinates of `pieces` are in 1 / `scale` nm. The finer unit allows a cut to end on an edge:
  /// its end is exactly on the edge as far as integers allow.
  Coord scale = 1;
  std::vector<Polygon> pieces;  ///< counter-clockwise, without straight corners
  CutCounts counts;
  double min_cut_angle_deg = 180;    ///< smallest angle between a cut and an edge
  int64_t ruled_cuts = 0;            ///< cuts that end at a corner chosen by the rule of 30 degrees
  double min_ruled_angle_deg = 180;  ///< smallest angle at the end corner of any ruled cut
};

/// Cuts islands, with or without holes, into convex pieces.
///
/// kBian: the method of Bian et al. 2005. A cut starts at a reflex corner. Its possible ends
/// (candidates) are the corners that this corner sees between the extensions of its edges. These
/// rules choose the end:
/// - Reflex candidates come first.
/// - Then candidates follow at which the cut makes no angle below 30 degrees.
/// - Among candidates of the same rank, the nearest one on the extension of an edge is first, then
///   the paper's weight decides.
/// - If there is no candidate, the end is the point where the bisector meets the boundary.
///
/// A cut from a hole to another ring is the bridge of this hole.
///
/// Other methods: first the rules above cut open the holes, then CGAL's method cuts the outlines.
/// The results of CGAL are checked. If CGAL cannot cut an outline (cgal_partition.h), Bian's method
/// cuts it, and CutCounts::replaced counts it.
///
/// REQUIRES: coordinates within +-2^52. Errors: Cancelled, checked once per cut; REQUEST_MALFORMED
/// if rings cross themselves or each other, or islands overlap; metadata `x_nm` and `y_nm`: the
/// position. Cost, n points: kBian O(n) per reflex corner plus the tests of candidates; kOptimal
/// O(n^4) in the worst case; kApproximate and kYMonotone O(n log n).
absl::StatusOr<ConvexPieces> Decompose(const MultiPolygon& islands, const DecomposeOptions& options,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::exposure
