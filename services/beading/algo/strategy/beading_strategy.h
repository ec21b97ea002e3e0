#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::beading {

/// How beads lie side by side across a place of some thickness, from one side of it to the other.
/// A bead of width 0 is a marker: the border between the walls and what the infill gets.
struct Beading {
  Coord thickness_nm = 0;
  std::vector<Coord> widths_nm;
  std::vector<Coord> locations_nm;  ///< of the beads' middles, from the first side
  /// Thickness less the sum of the widths; negative where a bead is widened beyond the outline.
  Coord left_over_nm = 0;

  int count() const { return static_cast<int>(widths_nm.size()); }
  friend bool operator==(const Beading&, const Beading&) = default;
};

/// Decides for each thickness how many beads lie side by side, and how wide and where they are.
///
/// What every strategy keeps (strategy_checks_test.h):
///   - Compute: widths and left-over sum up to the thickness exactly; widths and locations are
///     symmetric; for one count each width is continuous and non-decreasing in the thickness
///   - OptimalCount is non-decreasing, and TransitionThickness(n) is the least thickness at which
///     it exceeds n
///
/// Strategies are decorators: each changes what its parent says (strategy_factory.h).
/// Source: T. Kuipers et al., "A Framework for Adaptive Width Control of Dense Contour-Parallel
/// Toolpaths in FDM", Computer-Aided Design 128 (2020), section 4; CuraEngine's and PrusaSlicer's
/// strategies for the names and the meaning of the parameters.
class BeadingStrategy {
 public:
  virtual ~BeadingStrategy() = default;

  /// Beads for a place `thickness_nm` thick. Any count is answered, also one that is not optimal
  /// there: between two counts beads go over from one beading to the other. REQUIRES:
  /// thickness_nm >= 0, count >= 0. Cost: O(count).
  virtual Beading Compute(Coord thickness_nm, int count) const = 0;

  virtual int OptimalCount(Coord thickness_nm) const = 0;

  /// The thickness at which `count` beads have the width they should have.
  virtual Coord OptimalThickness(int count) const = 0;

  /// The least thickness with more than `lower_count` beads; kUnreachableNm if there is none.
  virtual Coord TransitionThickness(int lower_count) const = 0;

  /// Along the skeleton, over what length beads go over from `lower_count` to one more.
  virtual Coord TransitionLength(int lower_count) const = 0;

  /// Where in that length the transition thickness lies: 0 at the side of the lower count, 1 at the
  /// other one.
  virtual double TransitionAnchor(int lower_count) const = 0;

  /// Thicknesses, in ascending order, at which Compute has a kink or a step although the count
  /// stays: the skeleton gets a node there.
  virtual std::vector<Coord> Kinks() const = 0;
};

inline constexpr Coord kUnreachableNm = Coord{9'000} * kNmPerMm;

/// The most walls of a place, on both sides of it together: what has room for more beads is left to
/// the infill.
inline int MostWalls(const BeadingStrategy& strategy) {
  return strategy.OptimalCount(kUnreachableNm - 1) - 1;
}

}  // namespace slicefarm::beading
