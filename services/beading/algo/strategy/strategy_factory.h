#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Options of MakeStrategy.
struct StrategyOptions {
  Coord outer_width_nm = 400'000;
  Coord inner_width_nm = 400'000;
  /// Space in the middle at which a bead is added (min_bead_width).
  Coord min_width_nm = 340'000;
  /// Width that both halves of a middle bead must reach before it is split.
  Coord min_split_width_nm = 340'000;
  Coord max_width_nm = 800'000;    ///< largest width of a bead, unless its optimal width is larger
  Coord min_feature_nm = 100'000;  ///< setting min_feature_size; used if `widen_thin_places`
  bool widen_thin_places = true;   ///< true to add a WideningStrategy
  int distribution_count = 1;      ///< setting wall_distribution_count
  Coord transition_length_nm = 400'000;
  bool lock_outer_width = false;
  Coord outer_inset_nm = 0;
  Coord inner_inset_nm = 0;
  /// distance of the outermost bead from the next one, in addition to their widths, where there is
  /// infill
  Coord apart_nm = 0;
  Coord margin_nm = 0;  ///< width of the stripe along the outline where no bead is laid out
  int max_walls = 0;  ///< largest number of walls on either side; 0: no limit, walls fill the part
};

/// Returns the strategies as decorators of each other, innermost first:
///   Distributed    lays out n beads over a thickness.
///   Redistribute   lays out the outermost bead of each side, so that only inner beads vary.
///   Widening       lays out thicknesses that are too small for Distributed and Redistribute.
///                  It is inside Limited, because it must not mistake Limited's markers for beads.
///   OuterWallInset, InnerWallInset   move beads. They are inside Limited, to move its markers too.
///   Limited        changes the number of beads, so it is outside of all strategies above.
///   Margin         is outermost, because the thicknesses of all others exclude the margin.
///
/// Thresholds follow from the smallest widths in `options`. A middle bead is split in two at the
/// thickness at which both halves reach `min_split_width_nm`. A bead is added when the space for it
/// reaches `min_width_nm`.
std::unique_ptr<const BeadingStrategy> MakeStrategy(const StrategyOptions& options);

}  // namespace slicefarm::beading
