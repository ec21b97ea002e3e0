#pragma once

#include <vector>

#include "common/geometry/edge_index.h"
#include "services/infill/algo/lines/fitted_strips.h"
#include "services/infill/algo/linking/serpentine.h"

namespace slicefarm::infill {

/// The beads of solid lines and of the links between them.
///
/// Lines are as wide as their pitch, but for where the region's edge runs at a flat angle to them
/// (FittedStrips). A line ends so near to the edge that it fills its strip by itself. So a link is
/// thin: it holds only what the ends of its two lines lack, and lies along the edge of `lines`.
/// Nothing leaves the region: a fitted line that would comes to plain ends, or is plain all along.
class SolidBeads {
 public:
  struct Options {
    bool fitted = true;     ///< false: every line is as wide as the pitch
    double reach_nm = 0;    ///< distance from the region's edge to the edge of `lines`
    double link_share = 1;  ///< width of a link's strip, in pitches
  };

  /// `lines` are those of the region, inset by `reach_nm`; both, and what `lines` refers to, must
  /// outlive this. Cost: that of FittedStrips, and O(edges of the region).
  SolidBeads(const PolygonWithHoles& region, const ScanLines& lines,
             const std::vector<SerpentinePath>& paths, const Options& options);

  /// Returns the bead of a path from end to end. Where a line meets its link, two points in a row
  /// are equal: the width steps there. Cost: O(its points).
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
