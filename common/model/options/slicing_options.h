#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/polygon.h"
#include "common/model/options/hole_options.h"
#include "common/model/options/layer_heights.h"
#include "common/model/scene/mesh.h"

namespace slicefarm {

// Member comments begin with the name of the setting (the name in PrusaSlicer if it has the
// setting).

/// Treatment of a hole that begins in the ceiling of a wider recess (counterbore).
enum class CounterboreBridging : uint8_t {
  kNone,  ///< no bridging: the hole's walls are printed in the air
  /// One layer bridges the recess on two sides of the hole, the next layer on the other two sides.
  /// The hole begins on these bridges.
  kPartial,
  kSacrificial,  ///< one bridge over the whole recess; the user drills the hole through it later
};

/// Beads that follow the slope of the object's upper side within a layer (Z contouring).
struct SurfaceContour {
  bool on = false;          ///< setting zaa_enabled
  Coord least_nm = 50'000;  ///< `zaa_min_z`: least height of such a bead

  friend bool operator==(const SurfaceContour&, const SurfaceContour&) = default;
};

/// Object settings for slicing.
struct ObjectSlicingOptions {
  Coord layer_height_nm = 200'000;          ///< setting layer_height
  FillRule fill_rule = FillRule::kNonZero;  ///< `slicing_mode`: regular, even_odd, positive
  bool close_holes = false;  ///< `slicing_mode = close_holes`: only outer rings are used
  /// `slice_closing_radius`: closes cracks narrower than twice this value. Only used for meshes
  /// with open edges.
  Coord closing_radius_nm = 49'000;
  /// `xy_size_compensation`: grows the outlines and shrinks the holes
  Coord xy_compensation_nm = 0;
  Coord hole_compensation_nm = 0;  ///< `xy_hole_compensation`: additional growth of the holes
  /// True if the object is directly on the bed: its first layer has first_layer_height and gets the
  /// elephant foot compensation.
  bool on_bed = true;
  Coord elephant_foot_nm = 0;  ///< `elefant_foot_compensation`: shrinks the first layer on the bed
  /// `elefant_foot_compensation_layers`: layers over which the compensation fades out
  int32_t elephant_foot_layers = 1;
  /// Smallest width of a part that elephant_foot_nm leaves. PrusaSlicer uses width + spacing of the
  /// first layer's outer wall.
  Coord elephant_foot_min_width_nm = 757'000;
  /// Height of the object's bottom above the bed; included when the build height is checked.
  Coord lift_nm = 0;
  /// `spiral_vase`: first layer that is hollow and keeps only its largest outline. 0: no hollow
  /// layers.
  int32_t hollow_from = 0;
  /// Setting counterbore_hole_bridging.
  CounterboreBridging counterbores = CounterboreBridging::kNone;
  bool precise_top = false;  ///< `precise_z_height`: the last layers end at the object's top
  PolyholeOptions polyholes = {};
  PrintableOverhangs printable = {};
  SurfaceContour contour = {};
  AdaptiveHeights adaptive;
  /// `layer_height_profile`: layer heights at ascending z, interpolated linearly. They replace
  /// layer_height, height ranges and `adaptive`. Empty: no profile.
  std::vector<LayerHeightAt> height_profile;

  friend bool operator==(const ObjectSlicingOptions&, const ObjectSlicingOptions&) = default;
};

/// Job settings for slicing.
struct JobSlicingOptions {
  Coord first_layer_height_nm = 200'000;  ///< `first_layer_height`: height of the layer on the bed
  /// `open_loop_max_gap`: outlines with a gap up to this length are closed. Outlines with a wider
  /// gap are dropped and counted.
  Coord max_gap_nm = 2'000'000;
  /// `outline_resolution`: tolerance to which outlines are simplified
  Coord resolution_nm = 5'000;
  /// `bed_shape`; empty: no limit.
  Polygon bed = {{0, 0}, {250'000'000, 0}, {250'000'000, 210'000'000}, {0, 210'000'000}};
  /// `bed_exclude_area`: parts of the bed that must remain free
  std::vector<Polygon> excluded = {};
  /// `wrapping_exclude_area` with enable_wrapping_detection: part of the bed that must remain free
  std::vector<Polygon> wrapping = {};
  Coord max_print_height_nm = 0;  ///< setting max_print_height; 0: unlimited
  std::vector<ThumbnailSize> thumbnails = {{32, 32}, {300, 300}};  ///< setting thumbnails
  /// `best_object_pos`: place of a single part and of arranged parts on the bed, as shares of its
  /// width and depth
  double best_x = 0.5;
  double best_y = 0.5;
  Coord part_distance_nm = 6'000'000;  ///< `duplicate_distance`: distance between arranged copies
  /// Distance that is used instead of `part_distance_nm` if it is greater. With complete_objects it
  /// is extruder_clearance_radius. With brims it leaves part_distance_nm between the brims.
  Coord clearance_radius_nm = 0;

  friend bool operator==(const JobSlicingOptions&, const JobSlicingOptions&) = default;
};

/// Returns all areas of the bed that must remain free.
inline std::vector<Polygon> AllExcluded(const JobSlicingOptions& options) {
  std::vector<Polygon> all = options.excluded;
  all.insert(all.end(), options.wrapping.begin(), options.wrapping.end());
  return all;
}

/// Options of the slicing stage.
struct SlicingOptions : JobSlicingOptions {
  std::vector<ObjectSlicingOptions> objects = {{}};  ///< options of each object

  using Row = JobSlicingOptions;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.objects);
  }
  friend bool operator==(const SlicingOptions&, const SlicingOptions&) = default;
};

}  // namespace slicefarm
