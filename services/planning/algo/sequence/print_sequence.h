#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// An object that is printed completely before the next one begins.
struct SequenceItem {
  Polygon footprint;  ///< all that is printed of it (brim, supports), where it stands on the plate
  Coord height_nm = 0;
  std::string name;  ///< for messages
};

/// The head, as PrusaSlicer's settings of these names describe it.
struct SequenceOptions {
  Coord clearance_radius_nm = 20 * kNmPerMm;  ///< extruder_clearance_radius: around the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;  ///< extruder_clearance_height: gantry over nozzle
  /// How far in y the gantry, a bar along x, reaches to both sides of the nozzle; not given: it
  /// is over the whole plate.
  std::optional<Coord> gantry_reach_nm = {};
  Point start = {};  ///< where the nozzle comes from
};

/// The order in which to print, as indices of `items`: short objects first, with little travel.
///
/// An order is good if, while an object is printed, no finished one
///  - lies within clearance_radius_nm of the object's hull: so the hulls of any two objects must be
///    so far apart, in whichever order (to 1 um: what an arrangement put exactly there is
///    accepted);
///  - is taller than clearance_height_nm and within reach of the gantry in y. Without
///    gantry_reach_nm: only the last object may be taller.
/// Both are PrusaSlicer's rules up to 2.8 (sequential_print_horizontal_clearance_valid grows each
/// hull by half the radius less 0.1 um; sequential_print_vertical_clearance_valid), but it takes
/// the order as it comes and only checks it. 2.9 models the head in slices and asks an SMT solver.
///
/// The first rule does not depend on the order, and by the second a tall object and a short one
/// are always good with the short one first, and two tall ones that reach each other in y never
/// are. So an order exists if no pair is in conflict, and then all short objects, followed by all
/// tall ones, is one. Within both: nearest neighbour, then 2-opt on the distance of the boxes'
/// middles. Travels between objects must be made above all that stand: the writer's task.
///
/// Errors:  OBJECTS_COLLIDE, INVALID_ARGUMENT, for the first pair that no order helps: metadata
///          `first`, `second` (names), `first_index`, `second_index`, `rule` (`clearance` or
///          `gantry`). REQUEST_MALFORMED for no footprint or a negative height, OUT_OF_RANGE for
///          coordinates beyond kMaxCoord, REQUEST_TOO_LARGE for more than kMaxObjects,
///          SETTING_OUT_OF_RANGE for negative options.
/// Cost:    O(n^2) and O(corners) for each two objects near each other; 1,000 objects: 20 ms. The
///          order depends on where things are, not on the order of the input, but for equal ones.
/// Source:  G. A. Croes, "A Method for Solving Traveling-Salesman Problems", Operations Research 6
///          (1958): 2-opt.
absl::StatusOr<std::vector<size_t>> PrintSequence(std::span<const SequenceItem> items,
                                                  const SequenceOptions& options);

}  // namespace slicefarm::planning
