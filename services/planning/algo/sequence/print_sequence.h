#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Object that is printed completely before the next one begins.
struct SequenceItem {
  Polygon footprint;  ///< outline of the whole print of the object (brim, supports) on the plate
  Coord height_nm = 0;
  std::string name;  ///< name for messages
};

/// Dimensions of the head, as defined by PrusaSlicer's settings with these names.
struct SequenceOptions {
  /// `extruder_clearance_radius`: free radius around the nozzle
  Coord clearance_radius_nm = 20 * kNmPerMm;
  /// `extruder_clearance_height`: height of the gantry above the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;
  /// Reach of the gantry, a bar along x, to both sides of the nozzle in y. Without a value the
  /// gantry covers the whole plate.
  std::optional<Coord> gantry_reach_nm = {};
  /// Height of the lid above the nozzle, for machines with a bed that descends: only the last
  /// object may be taller. Without a value there is no lid.
  std::optional<Coord> lid_height_nm = {};
  /// Height of the nozzle below the head. The head passes over lower objects; the nozzle itself is
  /// up to 4 mm wide.
  Coord nozzle_height_nm = 0;
  Point start = {};  ///< position of the nozzle before the print
};

/// Returns the print order as indices of `items`: short objects first, with little travel.
///
/// An order is good if no finished object causes one of these conflicts while another object is
/// printed:
///  - The finished object is taller than nozzle_height_nm and within clearance_radius_nm of the
///  other object's hull, or it is within the nozzle's radius of it. The tolerance is 1 um, so an
///  arrangement at exactly this distance is accepted.
///  - The finished object is taller than clearance_height_nm and within reach of the gantry in y.
///  Without gantry_reach_nm only the last object may be taller.
///  - The finished object is taller than lid_height_nm.
/// The first two, with a nozzle_height_nm of 0, are PrusaSlicer's rules up to 2.8:
/// sequential_print_horizontal_clearance_valid grows each hull by half the radius less 0.1 um, and
/// sequential_print_vertical_clearance_valid. PrusaSlicer keeps the given order and only checks it.
/// Version 2.9 models the head in slices and uses an SMT solver.
///
/// By all rules a lower object before a taller one is good if the taller one before the lower one
/// is. So an order exists if no pair is in conflict with the lower object first: objects in groups
/// by the number of the heights above (nozzle, gantry, lid) that they exceed. Each group is ordered
/// by nearest neighbour, then 2-opt on the distance of the boxes' middles. The writer must make
/// travels between objects above all finished objects.
///
/// Errors:  OBJECTS_COLLIDE, INVALID_ARGUMENT, for the first pair that is in conflict in any order:
///          metadata `first`, `second` (names), `first_index`, `second_index`, `rule` (`clearance`,
///          `gantry` or `lid`). REQUEST_MALFORMED for no footprint or a negative height,
///          OUT_OF_RANGE for coordinates beyond kMaxCoord, REQUEST_TOO_LARGE for more than
///          kMaxObjects, SETTING_OUT_OF_RANGE for negative options.
/// Cost:    O(n^2), plus O(corners) for each two objects near each other; 1,000 objects: 20 ms. The
///          order depends on positions, not on the order of the input, except for equal objects.
/// Source:  G. A. Croes, "A Method for Solving Traveling-Salesman Problems", Operations Research 6
///          (1958): 2-opt.
absl::StatusOr<std::vector<size_t>> PrintSequence(std::span<const SequenceItem> items,
                                                  const SequenceOptions& options);

}  // namespace slicefarm::planning
