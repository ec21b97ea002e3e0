#pragma once

#include <vector>

#include "common/geometry/edge_index.h"
#include "services/infill/algo/lines/fitted_strips.h"
#include "services/infill/algo/linking/serpentine.h"

namespace slicefarm::infill {

/// Beads of solid lines and of the links between them.
///
/// Lines are as wide as their pitch, except beside parts of the region's boundary at a small angle
/// to the lines (FittedStrips). A line ends so near to the boundary that it fills its own strip up
/// to the boundary. A link is therefore thin: it only fills the area between the ends of its two
/// lines and the boundary. Links follow the boundary of the area that `lines` fill. No bead leaves
/// the region: a fitted line that would leave it has plain ends, or is plain along its whole
/// length.
class SolidBeads {
 public:
  /// Parameters of solid beads.
  struct Options {
    /// true: lines beside a boundary at a small angle get a wider or narrower strip (FittedStrips);
    /// false: every line is as wide as the pitch
    bool fitted = true;
    /// Distance from the region's boundary to the boundary of the area that `lines` fill, in nm.
    double reach_nm = 0;
    double link_share = 1;  ///< width of a link's strip, as a share of the pitch
  };

  /// Prepares the strips. `region`: the area that all beads together cover; `lines` fill this
  /// region inset by `reach_nm`. `lines`, and all data that it refers to, must outlive this object.
  /// Cost: the cost of FittedStrips, and O(edges of the region).
  SolidBeads(const PolygonWithHoles& region, const ScanLines& lines,
             const std::vector<SerpentinePath>& paths, const Options& options);

  /// Returns the bead of a path from end to end. Where a line meets its link, two consecutive
  /// points have the same position: the width steps there. Cost: O(points of the bead).
  std::vector<StripPoint> BeadOf(const SerpentinePath& path) const;

 private:
  using Bead = std::vector<StripPoint>;

  Bead LineFrom(int32_t place) const;
  bool Leaves(Point a, Point b) const { return a != b && edges_.Meets(a, b); }
  bool Leaves(const Bead& bead, const Bead& even) const;

  const ScanLines& lines_;
  const double link_nm_;
  EdgeIndex edges_;
  FittedStrips fitted_;
  FittedStrips even_;
};

}  // namespace slicefarm::infill
