#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::beading {

/// Layout of beads side by side across some thickness, from one side to the other. A bead of width
/// 0 is a marker: the boundary between the walls and the infill's area.
struct Beading {
  Coord thickness_nm = 0;
  std::vector<Coord> widths_nm;
  std::vector<Coord> locations_nm;  ///< positions of the beads' middles, from the first side
  /// Thickness minus the sum of the widths; negative if a bead is widened beyond the outline.
  Coord left_over_nm = 0;

  /// Returns the number of beads.
  int count() const { return static_cast<int>(widths_nm.size()); }
  friend bool operator==(const Beading&, const Beading&) = default;
};

/// Decides for each thickness how many beads are side by side, and their widths and positions.
///
/// Properties of every strategy (strategy_checks_test.h):
/// - Compute: widths and left-over sum up exactly to the thickness. Widths and positions are
///   symmetric. For a fixed count, each width is continuous and non-decreasing in the thickness.
/// - OptimalCount is non-decreasing. TransitionThickness(n) is the smallest thickness for which
///   OptimalCount exceeds n.
///
/// Strategies are decorators: each one changes the results of its parent (strategy_factory.h).
///
/// Source: T. Kuipers et al., "A Framework for Adaptive Width Control of Dense Contour-Parallel
/// Toolpaths in FDM", Computer-Aided Design 128 (2020), section 4. Names and meaning of the
/// parameters are from the strategies of CuraEngine and PrusaSlicer.
class BeadingStrategy {
 public:
  virtual ~BeadingStrategy() = default;

  /// Returns the beads for a thickness. Every count is allowed, also one that is not optimal for
  /// the thickness: between two counts, beads change from one layout to the next. REQUIRES:
  /// thickness_nm >= 0, count >= 0. Cost: O(count).
  virtual Beading Compute(Coord thickness_nm, int count) const = 0;

  /// Returns the best number of beads for a thickness.
  virtual int OptimalCount(Coord thickness_nm) const = 0;

  /// Returns the thickness at which `count` beads have their optimal width.
  virtual Coord OptimalThickness(int count) const = 0;

  /// Returns the smallest thickness with more than `lower_count` beads; kUnreachableNm if there is
  /// none.
  virtual Coord TransitionThickness(int lower_count) const = 0;

  /// Returns the length along the skeleton over which beads change from `lower_count` to
  /// `lower_count` + 1.
  virtual Coord TransitionLength(int lower_count) const = 0;

  /// Returns the position of the transition thickness, as a fraction of the transition length: 0 at
  /// the end with the lower count, 1 at the end with the higher count.
  virtual double TransitionAnchor(int lower_count) const = 0;

  /// Returns the thicknesses, in ascending order, at which Compute has a kink or a step for a fixed
  /// count. The skeleton gets a node at each of these thicknesses.
  virtual std::vector<Coord> Kinks() const = 0;
};

/// Thickness that no part reaches; it means that there is no transition.
inline constexpr Coord kUnreachableNm = Coord{9'000} * kNmPerMm;

/// Returns the largest number of walls, both sides together. The space inside these walls is left
/// to the infill.
inline int MostWalls(const BeadingStrategy& strategy) {
  return strategy.OptimalCount(kUnreachableNm - 1) - 1;
}

}  // namespace slicefarm::beading
