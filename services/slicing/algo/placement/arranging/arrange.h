#pragma once

#include <optional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// A part that wants a place on a bed. Copies are items of their own.
struct ArrangeItem {
  Polygon footprint;  ///< hull or outline, the object's origin at 0, 0; holes count as filled
  std::vector<double> rotations_deg = {0};  ///< ways round that it may lie, the best liked first
};

/// A part that has its place already.
struct FixedFootprint {
  Polygon footprint;  ///< where it stands
  int plate = 0;      ///< >= 0
};

struct ArrangeOptions {
  Polygon bed;                       ///< convex; below three points: a square of 2 m
  Coord distance_nm = 6 * kNmPerMm;  ///< between parts, >= 0; PrusaSlicer's min_object_distance
  std::vector<Polygon> excluded = {};  ///< areas of the bed where no part may be; may overlap
  Coord bed_margin_nm = 0;  ///< from the bed's edge and the excluded areas, >= 0
  int max_plates = 0;                ///< 0: as many as it takes
};

struct ItemPlace {
  int plate = 0;
  Point translation;  ///< after the rotation about 0, 0; whole micrometres
  double rotation_deg = 0;

  friend bool operator==(const ItemPlace&, const ItemPlace&) = default;
};

struct Arrangement {
  std::vector<std::optional<ItemPlace>> places;  ///< one for each item
  int plates = 0;                                ///< 0..n-1 are in use
  std::vector<size_t> left_over;                 ///< indices of the items without a place
};

/// Puts parts on beds: in few plates, each plate's parts close together around the bed's middle.
///
/// Largest first, each item goes to the best place of the first plate that has one; places are the
/// corners of the no-fit region, made of exact Minkowski sums of convex pieces (free_places.h).
/// Packed once outwards from the middle and, if that takes more than one plate, once more from the
/// front; the one of fewer plates counts. Equal items come as a grid instead where that takes no
/// more plates. At the end each plate without fixed parts is moved as a whole towards the bed's
/// middle.
///
/// Guarantees: no two parts on a plate nearer than distance_nm, none nearer to the bed's edge or to
/// an excluded area than bed_margin_nm (to 1 nm), whatever the input. Deterministic; the set of places does not depend on
/// the order of the items.
/// Errors:  INVALID_ARGUMENT: SETTING_OUT_OF_RANGE for a bed that is not convex, negative lengths
///          or plates; REQUEST_MALFORMED for an item without points or ways round; OUT_OF_RANGE for
///          coordinates beyond kMaxCoord; REQUEST_TOO_LARGE for more than kMaxObjects; each names
///          the `item` or `setting`. CANCELLED. What does not fit is left over.
/// Cost:    see the figures; footprints of many corners are packed as at most 12 convex pieces.
///
/// Why not libnest2d 5.0, with which PrusaSlicer arranged before 2.6: its concave parts overlap.
/// Bed 250 x 210 mm, distance 6 mm, no rotations, one core (CPU time):
///
///                                        libnest2d                 this
///   100 parts 30 x 20                    3 plates, 0.8 s           2 plates, 0.02 s
///   12 parts 60 x 31 (benchies)          1 plate, 0.05 s           1 plate, a grid, < 1 ms
///   40 parts 60 x 31                     3 plates, 0.2 s           3 plates, 3 ms
///   60 boxes from 10 x 10 to 69 x 59     3 plates (15 on the last) 3 plates (9), 0.1 s
///   20 brackets 60 x 60, 15 wide         31 pairs overlap          2 plates (13 + 7), 10 ms
///   1,000 boxes from 10 x 10 to 29 x 29  15 plates, 53 s           14 plates, 1.5 to 2.5 s
///   1,000 hulls, all different           -                         13 plates, 5 s
///   1,000 discs of 20                    -                         13 plates, 0.3 s (a grid: 14)
absl::StatusOr<Arrangement> Arrange(std::span<const ArrangeItem> items,
                                    std::span<const FixedFootprint> fixed,
                                    const ArrangeOptions& options, const CancelToken& cancel);

}  // namespace slicefarm::slicing
