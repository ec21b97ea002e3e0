#pragma once

#include <optional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Part that needs a position on a bed. Each copy is a separate item.
struct ArrangeItem {
  /// hull or outline of the part, with the object's origin at 0, 0; holes count as filled
  Polygon footprint;
  std::vector<double> rotations_deg = {0};  ///< allowed rotations about z, the preferred one first
};

/// Part with a fixed position.
struct FixedFootprint {
  Polygon footprint;  ///< outline of the part at its fixed position, in plate coordinates
  int plate = 0;      ///< plate index, >= 0
};

/// Options for arranging parts.
struct ArrangeOptions {
  Polygon bed;  ///< convex bed; fewer than three points mean a square of 2 m
  /// Distance between parts, >= 0; PrusaSlicer's min_object_distance.
  Coord distance_nm = 6 * kNmPerMm;
  std::vector<Polygon> excluded = {};  ///< areas of the bed where no part may be; may overlap
  Coord bed_margin_nm = 0;  ///< distance from the boundary of the bed and from excluded areas, >= 0
  int max_plates = 0;       ///< largest number of plates; 0: no limit
  /// Position of the middle of a plate's parts, as shares of the bed's width and depth.
  double middle_x = 0.5;
  double middle_y = 0.5;
};

/// Position of an item on a plate.
struct ItemPosition {
  int plate = 0;
  Point translation;  ///< applied after the rotation about 0, 0; whole micrometres
  double rotation_deg = 0;

  friend bool operator==(const ItemPosition&, const ItemPosition&) = default;
};

/// Result of arranging.
struct Arrangement {
  /// Position of each item, indexed by item; nullopt for the items in `left_over`.
  std::vector<std::optional<ItemPosition>> places;
  int plates = 0;                 ///< plates 0..n-1 are in use
  std::vector<size_t> left_over;  ///< indices of the items without a position
};

/// Arranges parts on beds: on few plates, with each plate's parts close together around the bed's
/// middle.
///
/// The largest item comes first. Each item goes to the best position on the first plate that has
/// one. Candidate positions are the corners of the no-fit region, which is computed by exact
/// Minkowski sums of convex pieces (free_positions.h). Items are packed outwards from the middle.
/// If this takes more than one plate, they are also packed from the front, and the packing with
/// fewer plates is used. Equal items form a grid instead if the grid does not need more plates.
/// Finally each plate without fixed parts is moved as a whole towards the position of its middle.
///
/// Guarantees: no two parts on a plate are closer than distance_nm. No part is closer to the bed's
/// edge or to an excluded area than bed_margin_nm (to 1 nm), for any input. The result is
/// deterministic; the set of positions does not depend on the order of the items.
///
/// Errors: INVALID_ARGUMENT, which names the `item` or `setting`, with reason
///   SETTING_OUT_OF_RANGE  a bed that is not convex; negative lengths or plates
///   REQUEST_MALFORMED     an item without points or rotations
///   OUT_OF_RANGE          coordinates beyond kMaxCoord
///   REQUEST_TOO_LARGE     more than kMaxObjects
/// and CANCELLED. Items that do not fit are left over.
///
/// Cost: see the figures. Footprints with many corners are packed as at most 12 convex pieces.
///
/// PrusaSlicer used libnest2d 5.0 for arranging before version 2.6. It is not used here because its
/// concave parts overlap. The table compares both. Bed 250 x 210 mm, distance 6 mm, no rotations,
/// one core (CPU time):
///
///                                        libnest2d                 this
///   100 parts 30 x 20:                   3 plates, 0.8 s           2 plates, 0.02 s
///   12 parts 60 x 31 (benchies):         1 plate, 0.05 s           1 plate, a grid, < 1 ms
///   40 parts 60 x 31:                    3 plates, 0.2 s           3 plates, 3 ms
///   60 boxes from 10 x 10 to 69 x 59:    3 plates (15 on the last) 3 plates (9), 0.1 s
///   20 brackets 60 x 60, 15 wide:        31 pairs overlap          2 plates (13 + 7), 10 ms
///   1,000 boxes from 10 x 10 to 29 x 29: 15 plates, 53 s           14 plates, 1.5 to 2.5 s
///   1,000 hulls, all different:          -                         13 plates, 5 s
///   1,000 discs of 20:                   -                         13 plates, 0.3 s (a grid: 14)
absl::StatusOr<Arrangement> Arrange(std::span<const ArrangeItem> items,
                                    std::span<const FixedFootprint> fixed,
                                    const ArrangeOptions& options, const CancelToken& cancel);

}  // namespace slicefarm::slicing
