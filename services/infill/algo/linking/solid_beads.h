#pragma once

#include <vector>

#include "common/geometry/edge_index.h"
#include "services/infill/algo/lines/fitted_strips.h"
#include "services/infill/algo/linking/serpentine.h"

namespace slicefarm::infill {

/// The beads of solid lines and of the links between them, beside walls: as wide as the pitch, in
/// turns too (solid_turns), but for where the region's edge is flat to the lines (fitted_strips).
/// Nothing leaves the region: what would, in a narrow bay or at a leaning edge, runs straight.
class SolidBeads {
 public:
  struct Options {
    bool fitted = true;    ///< else all is as wide as the pitch, and turns follow the edge
    double linked_nm = 0;  ///< how far from the region's edge lines are cut, and links run
    double free_nm = 0;    ///< how far from it ends lie that no link leads on from
  };

  /// `lines`: of the region, inset by `linked_nm`; both, and what `lines` refers to, must outlive
  /// this. Cost: as FittedStrips, and O(edges of the region).
  SolidBeads(const PolygonWithHoles& region, const ScanLines& lines,
             const std::vector<SerpentinePath>& paths, const Options& options);

  /// From end to end. Cost: O(its points).
  std::vector<StripPoint> BeadOf(const SerpentinePath& path) const;

 private:
  /// Two points or more.
  using Bead = std::vector<StripPoint>;

  Bead LineFrom(int32_t place) const;
  void AppendLink(const SerpentinePath& path, size_t piece, Bead& bead, Bead& next) const;
  bool AppendFitted(const SerpentinePath& path, size_t piece, Bead& bead, Bead& next) const;
  bool AppendTurn(const SerpentinePath& path, size_t piece, Bead& bead, Bead& next) const;
  void ExtendTip(int32_t place, StripPoint& line_end, StripPoint& link_end) const;
  StripPoint FreeEnd(int32_t place, StripPoint end) const;
  StripPoint Along(StripPoint p, double u_nm) const;
  bool Leaves(Point a, Point b) const { return a != b && edges_.Meets(a, b); }
  bool Leaves(const Bead& bead) const;
  double DistanceToEdge(Point p, double at_most_nm) const;

  const ScanLines& lines_;
  const Options options_;
  EdgeIndex edges_;
  FittedStrips fitted_;
  FittedStrips even_;
};

}  // namespace slicefarm::infill
