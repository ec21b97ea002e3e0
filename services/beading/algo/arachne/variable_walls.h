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
  double transition_angle = 0.1745;      ///< setting wall_transition_angle, in radians
  Coord transition_length_nm = 400'000;  ///< setting wall_transition_length
  Coord filter_deviation_nm = 100'000;   ///< setting wall_transition_filter_deviation
  /// Smallest width of a bead along the medial axis. The bead ends where it would be narrower.
  Coord min_middle_width_nm = 100'000;
  /// chord tolerance of curves of the skeleton; all beads beside a curve deviate by the same chords
  Coord chord_tolerance_nm = 5'000;
  Coord tolerance_nm = 5'000;  ///< tolerance to which each bead's points and widths are simplified
  /// Same as CountOptions::deciding_radius, but the position is (x, y) in the object's coordinates,
  /// in nm.
  std::function<double(double x, double y, double radius_nm)> deciding_radius = nullptr;
};

/// Bead of a wall. `line.thickness_nm` contains the widths that the bead strategy
/// (beading_strategy.h) has chosen.
struct WallLine {
  int inset = 0;
  /// True for a bead along the medial axis of a narrow area. No bead on the opposite side belongs
  /// to it.
  bool is_middle = false;
  ThickLine line;
};

/// Walls of an island.
struct VariableWalls {
  std::vector<WallLine> lines;
  MultiPolygon fill_area;  ///< area that gets infill, inside the markers (beads of width 0)
};

/// Returns the skeletal graphs of an island: one, or several if the inset below divides the island.
/// The outline is first tried unchanged, then after an inset of 1.5 um, which removes necks
/// narrower than 3 um. Returns nullopt if the Voronoi diagram fails its checks in both cases. Cost:
/// O(n log n), n points, about two thirds of MakeVariableWalls.
std::optional<std::vector<SkeletalGraph>> MakeSkeletons(const PolygonWithHoles& island,
                                                        const VariableWallOptions& options);

/// Returns the beads along the skeletons of one island. `options`: the same as for MakeSkeletons.
VariableWalls WallsAlong(std::vector<SkeletalGraph> skeletons, const BeadingStrategy& strategy,
                         const VariableWallOptions& options);

/// Returns beads along the outline of an island. `strategy` determines their number and widths for
/// each thickness. The beads cover the island except for the fill area.
///
/// Returns nullopt if MakeSkeletons returns nullopt. Source: Kuipers et al. 2020.
std::optional<VariableWalls> MakeVariableWalls(const PolygonWithHoles& island,
                                               const BeadingStrategy& strategy,
                                               const VariableWallOptions& options);

}  // namespace slicefarm::beading
