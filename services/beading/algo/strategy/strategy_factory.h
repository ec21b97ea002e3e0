#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options of MakeStrategy.
struct StrategyOptions {
  Coord outer_width_nm = 400'000;
  Coord inner_width_nm = 400'000;
  /// Smallest width of a bead that is added in the middle (min_bead_width).
  Coord min_width_nm = 340'000;
  /// Smallest width of the two halves into which a middle bead is split.
  Coord min_split_width_nm = 340'000;
  Coord max_width_nm = 800'000;    ///< largest width of any bead
  Coord min_feature_nm = 100'000;  ///< min_feature_size; used if `widen_thin_places`
  bool widen_thin_places = true;   ///< thin_walls
  int distribution_count = 1;      ///< wall_distribution_count
  Coord transition_length_nm = 400'000;
  bool lock_outer_width = false;
  Coord outer_inset_nm = 0;
  Coord inner_inset_nm = 0;
  Coord margin_nm = 0;  ///< width of the stripe along the outline where no bead is laid out
  int max_walls = 0;    ///< walls on either side; 0: as many as fill the part
};

/// Returns the strategies as decorators of each other, innermost first:
///   Distributed    lays out n beads over a thickness
///   Redistribute   handles the outer two beads, so that only inner ones vary
///   Widening       handles thicknesses too small for the two above; inside Limited, because it
///                  must not mistake the markers of Limited for beads
///   OuterWallInset, InnerWallInset   move beads; inside Limited, so that markers move with them
///   Limited        changes the number of beads: outside of all strategies that lay beads out
///   Margin         outermost, because the thicknesses of all others exclude the margin
///
/// Thresholds follow from the smallest width. A bead is split in two when both halves reach this
/// width. A bead is added when the space for it reaches this width.
std::unique_ptr<const BeadingStrategy> MakeStrategy(const StrategyOptions& options);

}  // namespace slicefarm::beading
