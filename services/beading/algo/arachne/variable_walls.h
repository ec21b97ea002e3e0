#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/geometry/skeleton/skeletal_graph.h"
#include "services/beading/algo/beads/thick_line.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options for walls of variable width.
struct VariableWallOptions {
  double transition_angle = 0.1745;      ///< wall_transition_angle, in radians
  Coord transition_length_nm = 400'000;  ///< wall_transition_length
  Coord filter_deviation_nm = 100'000;   ///< wall_transition_filter_deviation
  /// Width at which beads along the middle end if they become narrower.
  Coord min_middle_width_nm = 100'000;
  /// tolerance of curves; all beads side by side have it in common
  Coord chord_tolerance_nm = 5'000;
  Coord tolerance_nm = 5'000;  ///< tolerance of the positions and widths of each single bead
  /// Same as CountOptions::deciding_radius, but the position is (x, y) in the plane, in nm.
  std::function<double(double x, double y, double radius_nm)> deciding_radius = nullptr;
};

/// Bead of a wall. `line.thickness_nm` has the widths that the bead strategy has chosen.
struct WallLine {
  int inset = 0;
  /// True for a bead along the middle of a narrow area, without a bead on the opposite side.
  bool is_middle = false;
  ThickLine line;
};

/// Walls of an island.
struct VariableWalls {
  std::vector<WallLine> lines;
  MultiPolygon fill_area;  ///< area inside the markers (beads of width 0)
};

/// Returns the skeletal graphs of an island: usually one, several if the island is divided into
/// parts. Returns nullopt if no Voronoi diagram of the outline can be trusted. The outline is first
/// tried unchanged, then after an inset of 1.5 um, which removes necks narrower than 3 um. Cost:
/// O(n log n), n points, about two thirds of MakeVariableWalls.
std::optional<std::vector<SkeletalGraph>> MakeSkeletons(const PolygonWithHoles& island,
                                                        const VariableWallOptions& options);

/// Returns the beads along these skeletons.
VariableWalls WallsAlong(std::vector<SkeletalGraph> skeletons, const BeadingStrategy& strategy,
                         const VariableWallOptions& options);

/// Returns beads along the outline of an island. `strategy` determines their number and widths for
/// each thickness. The beads cover the island except for the areas inside the markers.
///
/// Returns nullopt if MakeSkeletons does. Source: Kuipers et al. 2020.
std::optional<VariableWalls> MakeVariableWalls(const PolygonWithHoles& island,
                                               const BeadingStrategy& strategy,
                                               const VariableWallOptions& options);

}  // namespace slicefarm::beading
