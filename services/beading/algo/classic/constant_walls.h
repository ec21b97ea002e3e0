#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Widths and distances of the walls of one layer. A bead of width w is laid out as a rectangle as
/// wide as its spacing s (see common/model/bead_section.h): rectangles tile. The outermost bead
/// alone keeps its full width to the outline, because nothing lies beside it there.
struct WallPlan {
  int perimeters = 0;
  Coord external_width_nm = 0;
  Coord inner_width_nm = 0;
  Coord external_spacing_nm = 0;
  Coord inner_spacing_nm = 0;
  bool gap_fill = false;  ///< whether to look for gaps between walls
  /// Places too thin for two of the outermost walls get one bead; else a loop that overlaps itself,
  /// as PrusaSlicer lays it, if one wall fits: what is not printed at all would be missing.
  bool thin_walls = false;
  Coord least_tip_nm = 0;  ///< beside a wall, beads of thin walls shorter than this stay out

  static WallPlan Make(int perimeters, Coord external_width_nm, Coord inner_width_nm,
                       Coord layer_height_nm);
};

/// A region that no wall covers and that is too narrow for one.
struct Gap {
  PolygonWithHoles region;
  bool along_outline =
      false;  ///< bounded by the island's outline: a bead in it keeps its full width inside
};

struct IslandWalls {
  std::vector<MultiPolygon> centre_lines;  ///< by inset, outermost first; rings of walls
  std::vector<Gap> gaps;
  MultiPolygon fill_area;  ///< what the infill's rectangles may cover
};

/// Insets an island wall by wall. A wall is laid only where two opposite ones fit side by side (of
/// the outermost ones: if WallPlan::thin_walls); what stays uncovered between walls, or beside the
/// outline, comes back as gaps, and what is left inside the last wall as the fill area.
///
/// Invariant: rectangles of the walls, gaps and fill area tile the island, but for corners
/// (miters), loops that overlap themselves, and the stripe of (width - spacing) / 2 along the
/// outline. Cost: with no gap O(n) a wall; else a handful of polygon sweeps a wall.
IslandWalls MakeConstantWalls(const PolygonWithHoles& island, const WallPlan& plan);

/// Where a connected area is narrower than some width.
struct NarrowParts {
  MultiPolygon parts;
  bool are_all = false;  ///< the area is narrow everywhere
};

/// Invariant: what discs of `width_nm` reach within `area`, and the parts, tile it, but for 5 um
/// along the edges that they share. Cost: O(n) if it is wide throughout; else a few polygon sweeps.
NarrowParts FindNarrowParts(const PolygonWithHoles& area, Coord width_nm);

}  // namespace slicefarm::beading
