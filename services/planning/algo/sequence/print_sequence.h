#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// One copy on the plate that is printed completely before the next one begins.
struct SequenceItem {
  /// outline of the whole print of the copy (part, brim, supports), in plate coordinates
  Polygon footprint;
  Coord height_nm = 0;
  std::string name;  ///< name for messages
};

/// Dimensions of the print head and the machine around it.
struct SequenceOptions {
  /// `extruder_clearance_radius`: radius around the nozzle that the head needs
  Coord clearance_radius_nm = 20 * kNmPerMm;
  /// `extruder_clearance_height`: height of the gantry above the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;
  /// Distance in y from the nozzle that the gantry, a bar along x, reaches to both sides. Without a
  /// value the gantry covers the whole plate.
  std::optional<Coord> gantry_reach_nm = {};
  /// Height of the lid above the nozzle, for machines with a bed that descends: only the last
  /// object may be taller. Without a value there is no lid.
  std::optional<Coord> lid_height_nm = {};
  /// Height of the head's underside above the nozzle's tip. The head passes over objects lower than
  /// this; such objects only have to keep away from the nozzle itself, which is up to 4 mm wide.
  Coord nozzle_height_nm = 0;
  Point start = {};  ///< position of the nozzle before the print
};

/// Returns the print order as indices of `items`: short objects first, with little travel.
///
/// An order is good if no finished object causes one of these conflicts while another object is
/// printed:
///   1 Clearance: the finished object is taller than nozzle_height_nm and nearer to the other
///     object's hull than clearance_radius_nm. For lower finished objects, the radius of the nozzle
///     applies instead. The tolerance is 1 um, so an arrangement at exactly this distance is
///     accepted.
///   2 Gantry: the finished object is taller than clearance_height_nm and within reach of the
///     gantry in y. Without gantry_reach_nm only the last object may be taller.
///   3 Lid: the finished object is taller than lid_height_nm.
///
/// The rules for clearance and gantry, with a nozzle_height_nm of 0, are PrusaSlicer's rules up to
/// 2.8. There, sequential_print_horizontal_clearance_valid grows each hull by half the radius less
/// 0.1 um, and sequential_print_vertical_clearance_valid checks heights. PrusaSlicer keeps the
/// given order and only checks it. Version 2.9 models the head in slices and uses an SMT solver.
///
/// If two objects can be printed in some order, they can be printed with the lower one first. So an
/// order exists if no pair is in conflict in this order. Objects are grouped by the number of the
/// heights above (nozzle, gantry, lid) that they exceed, and groups are printed in ascending order.
/// Each group is ordered by nearest neighbour, then 2-opt on the distance of the boxes' middles.
/// The writer must make travels between objects above all finished objects.
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
