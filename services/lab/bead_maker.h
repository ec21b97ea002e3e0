#pragma once

#include <memory>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/beading/algo/arachne/variable_walls.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::lab {

/// Options for the beads of walls.
struct BeadMakerOptions {
  double width_mm = 0.5;
  double min_feature_mm = 0.3;
  double transition_angle = 45;  ///< bead strategy's transition angle, in degrees
  int walls = 0;  ///< number of walls on each side of a part; 0: enough to fill the part
};

/// Figures summed over several outlines.
struct BeadTotals {
  int outlines = 0;
  /// number of islands for which no skeleton could be computed (BeadMaker::Constant)
  int fallbacks = 0;
  double seconds = 0;
  double diagram_s = 0;
};

/// Makes the beads of outlines as in the paper of Kuipers et al. 2020: neighbouring beads touch,
/// and the outermost beads reach the outline.
class BeadMaker {
 public:
  explicit BeadMaker(const BeadMakerOptions& options);

  /// Returns the beads of one outline, and adds its figures to `totals`.
  std::vector<beading::WallLine> Make(const MultiPolygon& islands, BeadTotals& totals) const;

 private:
  beading::VariableWalls MakeIsland(const PolygonWithHoles& island, BeadTotals& totals) const;
  /// Returns the beads of an island for which no skeleton could be computed: insets of constant
  /// width, and lines along the gaps between them.
  beading::VariableWalls Constant(const PolygonWithHoles& island) const;

  Coord width_nm_ = 0;
  Coord least_nm_ = 0;
  int walls_ = 0;
  std::unique_ptr<const beading::BeadingStrategy> strategy_;
  beading::VariableWallOptions walls_options_;
};

}  // namespace slicefarm::lab
