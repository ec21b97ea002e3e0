#pragma once

#include <memory>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

struct StrategyOptions {
  Coord outer_width_nm = 400'000;
  Coord inner_width_nm = 400'000;
  Coord min_width_nm = 340'000;        ///< min_bead_width: of a bead that is added in the middle
  Coord min_split_width_nm = 340'000;  ///< of the two that a bead in the middle is split into
  Coord max_width_nm = 800'000;        ///< no bead is ever wider
  Coord min_feature_nm = 100'000;      ///< min_feature_size, if thin places are widened
  bool widen_thin_places = true;       ///< thin_walls
  int distribution_count = 1;          ///< wall_distribution_count
  Coord transition_length_nm = 400'000;
  bool lock_outer_width = false;
  Coord outer_inset_nm = 0;
  Coord inner_inset_nm = 0;
  Coord margin_nm = 0;  ///< along the outline, that no bead is laid out in
  int max_walls = 0;    ///< on either side; 0: as many as fill the part
};

/// The strategies one on top of the other, innermost first:
///   Distributed    lays out n beads over a thickness
///   Redistribute   takes the outer two out of that, so that only inner ones vary
///   Widening       decides on places too thin for what the two above accept; below Limited, whose
///                  markers it must not take for beads
///   OuterWallInset, InnerWallInset   move what is laid out; before Limited, so that markers follow
///   Limited        changes the number of beads: after all that lay them out
///   Margin         last, because the others' thicknesses are what it leaves
/// Thresholds follow from the least width: a bead is split in two when both halves reach it, one is
/// added when the place for it does.
std::unique_ptr<const BeadingStrategy> MakeStrategy(const StrategyOptions& options);

}  // namespace slicefarm::beading
