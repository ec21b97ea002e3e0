#pragma once

#include <span>
#include <vector>

#include "common/model/layers/surface_facet.h"
#include "common/model/options/region_motion.h"
#include "common/model/path.h"
#include "services/motion/algo/toolpath/path_segment.h"
#include "services/motion/algo/toolpath/printed_heights.h"
#include "services/motion/algo/toolpath/top_surface.h"

namespace slicefarm::motion {

/// Point of a path that follows the surface.
struct ContourPoint {
  Point point;
  Coord width_nm = 0;  ///< mean width of the edge that ends here; of the first edge at the start
  Coord up_nm = 0;     ///< height of the nozzle above the layer's top, at most 0

  friend bool operator==(const ContourPoint&, const ContourPoint&) = default;
};

/// Z contouring of one section: top surfaces, ironing and the two kinds of walls follow the
/// object's upper side instead of being level. The paths of the section must be passed in the order
/// of printing, because the nozzle may dip only a little below beads that are already printed.
class SurfaceFollower {
 public:
  /// `facets` must outlive this object. `height_nm`: height of the layer. `nozzle_nm`: diameter of
  /// the nozzle; its flat tip is twice as wide.
  SurfaceFollower(std::span<const SurfaceFacet> facets, Coord height_nm, Coord nozzle_nm);

  /// Returns the points at which a path is printed, with the closing edge. Between two points the
  /// height changes linearly. A path that stays level gives no points.
  ///
  /// - A path is lowered to the surface if the surface is less than a layer below the layer's top.
  ///   At least contour_least_nm of the bead's height remains. A path is never raised.
  /// - A wall on a slope above contour_edge_slope_rad is lowered further: by half its width times
  ///   the sine of the slope. Then its outer edge is at the surface (as in OrcaSlicer).
  /// - The nozzle dips at most 0.05 mm below beads that are already printed beside the path.
  ///
  /// Cost: O(length / 0.1 mm). Source: ContourZ of BambuStudio-ZAA and OrcaSlicer, without its rays
  /// through the mesh.
  std::vector<ContourPoint> Follow(const Path& path, const RegionMotion& region);

 private:
  /// Place at which the surface is measured.
  struct Sample {
    ContourPoint at;
    bool corner = true;  ///< true for a point of the path
    bool near = false;   ///< true if the surface may be near
  };

  Coord WantedUp(Point point, Coord width_nm, Feature feature, const RegionMotion& region) const;
  std::vector<Sample> SamplesOf(const Path& path, const RegionMotion& region) const;
  void AppendSamples(const PathSegment& segment, Feature feature, const RegionMotion& region,
                     std::vector<Sample>& samples) const;
  void RaiseOverPrinted(const RegionMotion& region, std::vector<Sample>& samples);
  void Print(const Sample& sample);
  static std::vector<ContourPoint> Thinned(std::span<const Sample> samples);

  Coord height_nm_;
  Coord reach_nm_;  ///< distance from the surface at which beads matter
  TopSurface surface_;
  PrintedHeights printed_;
};

}  // namespace slicefarm::motion
