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
  Coord min_middle_width_nm = 100'000;   ///< beads along the middle end where they become narrower
  Coord chord_tolerance_nm = 5'000;      ///< tolerance of curves, equal for all beads side by side
  Coord tolerance_nm = 5'000;  ///< tolerance of the positions and widths of each single bead
  /// See CountOptions; here by a position in the plane.
  std::function<double(double x, double y, double radius_nm)> deciding_radius = nullptr;
};

/// Bead with the widths `line.thickness_nm` of its strategy's layout.
struct WallLine {
  int inset = 0;
  bool is_middle = false;  ///< true if it runs along the middle of a part, with no bead opposite
  ThickLine line;
};

/// Walls of an island.
struct VariableWalls {
  std::vector<WallLine> lines;
  MultiPolygon fill_area;  ///< area inside the markers
};

/// Returns the skeletal graphs of an island, one for each part into which it falls. Returns nullopt
/// if no Voronoi diagram of the outline can be trusted. The outline is tried unchanged and after
/// opening parts that are closer to each other than 3 um. Cost: O(n log n), about two thirds of
/// MakeVariableWalls.
std::optional<std::vector<SkeletalGraph>> MakeSkeletons(const PolygonWithHoles& island,
                                                        const VariableWallOptions& options);

/// Returns the beads along these skeletons.
VariableWalls WallsAlong(std::vector<SkeletalGraph> skeletons, const BeadingStrategy& strategy,
                         const VariableWallOptions& options);

/// Returns beads along the outline of an island. `strategy` determines their number and widths for
/// each thickness. They cover the island except for the areas inside the markers.
///
/// Returns nullopt if there are no skeletons. Source: Kuipers et al. 2020.
std::optional<VariableWalls> MakeVariableWalls(const PolygonWithHoles& island,
                                               const BeadingStrategy& strategy,
                                               const VariableWallOptions& options);

}  // namespace slicefarm::beading
