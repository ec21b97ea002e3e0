#pragma once

#include <vector>

#include "common/geometry/edge_index.h"
#include "services/infill/algo/lines/fitted_strips.h"
#include "services/infill/algo/linking/serpentine.h"

namespace slicefarm::infill {

/// Beads of solid lines and of the links between them.
///
/// Lines are as wide as their pitch, except where the region's edge runs at a flat angle to them
/// (FittedStrips). A line ends so near to the edge that it fills its own strip. A link is therefore
/// thin: it fills only the space that the ends of its two lines leave empty, and follows the edge
/// of `lines`. No bead leaves the region: a fitted line that would leave it has plain ends, or is
/// plain along its whole length.
class SolidBeads {
 public:
  /// Parameters of solid beads.
  struct Options {
    bool fitted = true;     ///< false: every line is as wide as the pitch
    double reach_nm = 0;    ///< distance from the region's edge to the edge of `lines`
    double link_share = 1;  ///< width of a link's strip, in pitches
  };

  /// Prepares the strips. `lines` belong to the region, inset by `reach_nm`. `lines`, and all data
  /// that it refers to, must outlive this object. Cost: the cost of FittedStrips, and O(edges of
  /// the region).
  SolidBeads(const PolygonWithHoles& region, const ScanLines& lines,
             const std::vector<SerpentinePath>& paths, const Options& options);

  /// Returns the bead of a path from end to end. Where a line meets its link, two consecutive
  /// points are equal: the width steps there. Cost: O(its points).
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
