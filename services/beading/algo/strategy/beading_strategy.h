#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::beading {

/// Layout of beads side by side across a part of some thickness, from one side to the other. A bead
/// of width 0 is a marker: the boundary between the walls and the infill's area.
struct Beading {
  Coord thickness_nm = 0;
  std::vector<Coord> widths_nm;
  std::vector<Coord> locations_nm;  ///< distances of the beads' middle lines from the first side
  /// Thickness minus the sum of the widths; negative if a bead is widened beyond the outline.
  Coord left_over_nm = 0;

  /// Returns the number of beads.
  int count() const { return static_cast<int>(widths_nm.size()); }
  friend bool operator==(const Beading&, const Beading&) = default;
};

/// Decides for each thickness of a part how many beads are side by side, and their widths and
/// positions.
///
/// Properties of every strategy (strategy_checks_test.h):
/// - Compute: widths and left-over sum up exactly to the thickness. Widths and positions are
///   symmetric. For a fixed count, each width is continuous and non-decreasing in the thickness.
/// - OptimalCount is non-decreasing. TransitionThickness(n) is the smallest thickness for which
///   OptimalCount exceeds n.
/// - With more beads than MostWalls, and from the largest of Kinks on, the beads of the first side
///   do not depend on the thickness.
///
/// Strategies are decorators: each one changes the results of its parent (strategy_factory.h).
///
/// Source: T. Kuipers et al., "A Framework for Adaptive Width Control of Dense Contour-Parallel
/// Toolpaths in FDM", Computer-Aided Design 128 (2020), section 4. Names and meaning of the
/// parameters are from the strategies of CuraEngine and PrusaSlicer.
class BeadingStrategy {
 public:
  virtual ~BeadingStrategy() = default;

  /// Returns the layout of `count` beads for a thickness. Counts that are not optimal for the
  /// thickness are also allowed: in a transition between two counts, beads change from one layout
  /// to the next. REQUIRES: thickness_nm >= 0, count >= 0. Cost: O(count).
  virtual Beading Compute(Coord thickness_nm, int count) const = 0;

  /// Returns the best number of beads for a thickness.
  virtual int OptimalCount(Coord thickness_nm) const = 0;

  /// Returns the thickness at which each of `count` beads has its optimal width.
  virtual Coord OptimalThickness(int count) const = 0;

  /// Returns the smallest thickness for which OptimalCount exceeds `lower_count`; kUnreachableNm if
  /// there is none.
  virtual Coord TransitionThickness(int lower_count) const = 0;

  /// Returns the length along the skeleton, in nm, over which beads change from `lower_count` to
  /// `lower_count` + 1.
  virtual Coord TransitionLength(int lower_count) const = 0;

  /// Returns at which fraction of the transition length the skeleton has the transition thickness:
  /// 0 at the end with the lower count, 1 at the end with the higher count.
  virtual double TransitionAnchor(int lower_count) const = 0;

  /// Returns the thicknesses, in ascending order, at which the result of Compute has a kink or a
  /// step for some fixed count. The skeleton gets a node at each of these thicknesses.
  virtual std::vector<Coord> Kinks() const = 0;
};

/// Thickness that no part reaches. As a transition thickness, it means that there is no transition.
inline constexpr Coord kUnreachableNm = Coord{9'000} * kNmPerMm;

/// Returns the largest number of beads on both sides together. The area between the two sides is
/// left to the infill. REQUIRES: `strategy` contains a LimitedStrategy.
inline int MostWalls(const BeadingStrategy& strategy) {
  return strategy.OptimalCount(kUnreachableNm - 1) - 1;
}

}  // namespace slicefarm::beading
