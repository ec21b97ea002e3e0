#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/geometry/skeleton/skeletal_graph.h"
#include "services/beading/algo/beads/thick_line.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

struct VariableWallOptions {
  double transition_angle = 0.1745;      ///< radians: wall_transition_angle
  Coord transition_length_nm = 400'000;  ///< wall_transition_length
  Coord filter_deviation_nm = 100'000;   ///< wall_transition_filter_deviation
  Coord min_middle_width_nm = 100'000;   ///< beads along the middle end where they get narrower
  Coord chord_tolerance_nm = 5'000;      ///< of curves, in all beads beside each other alike
  Coord tolerance_nm = 5'000;            ///< of a bead's places and widths, on its own
  /// See CountOptions; by place in the plane.
  std::function<double(double x, double y, double radius_nm)> deciding_radius = nullptr;
};

/// A bead, `line.thickness_nm` wide as its strategy laid it out.
struct WallLine {
  int inset = 0;
  bool is_middle = false;  ///< runs along the middle of a place, with no bead opposite
  ThickLine line;
};

struct VariableWalls {
  std::vector<WallLine> lines;
  MultiPolygon fill_area;  ///< what lies within the markers
};

/// The skeletal graphs of an island, of as many parts as it falls into. nullopt where no Voronoi
/// diagram of the outline could be trusted, although it was tried as it is, and with what is nearer
/// to itself than 3 um opened.
/// Cost: O(n log n), about two thirds of MakeVariableWalls.
std::optional<std::vector<SkeletalGraph>> MakeSkeletons(const PolygonWithHoles& island,
                                                        const VariableWallOptions& options);

/// The beads along these skeletons.
VariableWalls WallsAlong(std::vector<SkeletalGraph> skeletons, const BeadingStrategy& strategy,
                         const VariableWallOptions& options);

/// Beads along the outline of an island, as many and as wide as `strategy` says for each place's
/// thickness. What comes out covers the island but for the markers' insides.
///
/// nullopt where there are no skeletons.
/// Source: Kuipers et al. 2020.
std::optional<VariableWalls> MakeVariableWalls(const PolygonWithHoles& island,
                                               const BeadingStrategy& strategy,
                                               const VariableWallOptions& options);

}  // namespace slicefarm::beading
