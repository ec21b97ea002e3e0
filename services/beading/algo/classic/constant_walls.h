#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Number, widths and spacings of the walls of one layer. A bead of width w is laid out as a
/// rectangle as wide as its spacing s (see common/model/bead_section.h), because rectangles tile.
/// The outermost bead's outer half has the full width, because no bead is beside it there.
struct WallPlan {
  int perimeters = 0;
  Coord external_width_nm = 0;
  Coord inner_width_nm = 0;
  Coord external_spacing_nm = 0;
  Coord inner_spacing_nm = 0;
  /// distance of the outermost wall from the next one, in addition to their spacings
  Coord apart_nm = 0;
  Coord min_bead_nm = 0;  ///< width of the narrowest bead of a wall; 0: min_bead_width
  Coord min_top_nm = 0;   ///< width of the narrowest top surface that inner walls go around
  bool gap_fill = false;  ///< true to search for gaps between walls
  /// If true, parts too thin for two outermost walls get one bead. If false, they get a loop that
  /// overlaps itself, as in PrusaSlicer, if one wall fits. Otherwise they would not be printed at
  /// all.
  bool thin_walls = false;
  /// Smallest length of a bead in a gap, in nm, if the island also has walls. Shorter beads are
  /// omitted.
  Coord least_tip_nm = 0;

  friend bool operator==(const WallPlan&, const WallPlan&) = default;

  /// Returns the plan of walls with these widths.
  static WallPlan Make(int perimeters, Coord external_width_nm, Coord inner_width_nm,
                       Coord layer_height_nm);
};

/// Region that no wall covers and that is too narrow for a wall.
struct Gap {
  PolygonWithHoles region;
  /// True if the gap borders on the island's outline. Then its bead must stay inside the outline.
  bool along_outline = false;
};

/// Result of MakeConstantWalls.
struct IslandWalls {
  /// centre lines of walls; indexed by inset, outermost first
  std::vector<MultiPolygon> centre_lines;
  std::vector<Gap> gaps;
  MultiPolygon fill_area;  ///< area that the rectangles of infill beads may cover
};

/// Insets an island wall by wall. An inner wall is laid only where two opposite walls fit side by
/// side. The outermost wall follows the same rule only if WallPlan::thin_walls is set. Uncovered
/// areas between walls, or along the outline, are returned as gaps. The remaining area inside the
/// last wall is the fill area.
///
/// Invariant: rectangles of the walls, gaps and fill area tile the island. Exceptions are corners
/// (miters), loops that overlap themselves, and the stripe of (width - spacing) / 2 along the
/// outline. Cost: without gaps O(n) per wall, n points; otherwise a few polygon sweeps per wall.
IslandWalls MakeConstantWalls(const PolygonWithHoles& island, const WallPlan& plan);

/// Parts of an area that are narrower than a given width.
struct NarrowParts {
  MultiPolygon parts;
  bool are_all = false;  ///< true if the area is narrow everywhere
};

/// Returns the parts of `area` that are narrower than `width_nm`. Nothing is returned if the area
/// is not narrow everywhere and its narrow parts are together smaller than `least_area_nm2`.
/// Invariant: these parts, and the area that discs of diameter `width_nm` reach within `area`, tile
/// `area`, except for 5 um along their common edges. Cost: O(n), n points, if `area` is wide
/// everywhere; otherwise a few polygon sweeps.
NarrowParts FindNarrowParts(const PolygonWithHoles& area, Coord width_nm,
                            double least_area_nm2 = 0);

}  // namespace slicefarm::beading
