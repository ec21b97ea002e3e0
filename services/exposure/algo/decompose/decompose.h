#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

struct DecomposeOptions {
  DecomposeMethod method = DecomposeMethod::kBian;
  /// Corners are left out where that moves the border by less than this, and all of them change the
  /// area by at most 2e-10 of it.
  double merge_nm = 1'000;
  /// Another choice of cuts of nearly the same quality: other corners come first, and of the ends
  /// that the rules prefer the next ones are taken. 0: the paper's.
  int32_t variant = 0;
};

/// Convex pieces that cover the islands once.
struct ConvexPieces {
  /// Coordinates are in 1 / `scale` nm: ends of cuts that are no corners lie exactly on the edges
  /// that they divide, as far as integers allow.
  Coord scale = 1;
  std::vector<Polygon> pieces;  ///< counter-clockwise, without straight corners
  CutCounts counts;
  double min_cut_angle_deg = 180;  ///< least angle between a cut and an edge
  int64_t ruled_cuts = 0;          ///< that end in a corner which the rule of 30 degrees has chosen
  double min_ruled_angle_deg = 180;  ///< of these, at that corner
};

/// Cuts islands, holes or not, into convex pieces.
///
/// kBian: Bian et al. 2005 with these rules: for a reflex corner, among the corners that it sees
/// within the extensions of its edges, those that are reflex, then those where the cut makes no
/// angle below 30 degrees; the nearest on the extension of an edge first, then by the paper's
/// weight; if there is none, the place where the bisector meets the border. A cut from a hole to
/// another ring is that hole's bridge.
///
/// The others are CGAL's, after the holes were cut open by the same rules; what they return is
/// checked. Outlines that they cannot do (cgal_partition.h) are cut by Bian's method instead, and
/// counted (CutCounts::replaced).
///
/// REQUIRES: coordinates within +-2^52.
/// Errors:  Cancelled, polled once a cut; REQUEST_MALFORMED for rings that cross themselves or each
///          other, or where islands overlap; metadata `x_nm` and `y_nm`: the place.
/// Cost:    kBian: O(n) a reflex corner and the candidates' tests; kOptimal O(n^4) at worst;
///          kApproximate and kYMonotone O(n log n).
absl::StatusOr<ConvexPieces> Decompose(const MultiPolygon& islands, const DecomposeOptions& options,
                                       const CancelToken& cancel = {});

}  // namespace slicefarm::exposure
