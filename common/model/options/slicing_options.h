#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/polygon.h"
#include "common/model/options/layer_heights.h"
#include "common/model/scene/mesh.h"

namespace slicefarm {

/// Names in the comments are the settings' (PrusaSlicer's, where it has the setting).

/// Treatment of a hole that begins over a wider recess.
enum class CounterboreBridging : uint8_t {
  kNone,         ///< its edge is printed on air
  kPartial,      ///< bridges beside it, others across those, and then the hole
  kSacrificial,  ///< a bridge over the recess, to be drilled through
};

/// Settings of one object that slicing needs.
struct ObjectSlicingOptions {
  Coord layer_height_nm = 200'000;          ///< layer_height
  FillRule fill_rule = FillRule::kNonZero;  ///< slicing_mode: regular, even_odd, positive
  bool close_holes = false;                 ///< slicing_mode = close_holes: outer rings alone count
  /// slice_closing_radius: cracks narrower than twice this are closed, in meshes that are not
  /// closed only.
  Coord closing_radius_nm = 49'000;
  Coord xy_compensation_nm = 0;    ///< xy_size_compensation: grows the outlines, holes shrink
  Coord hole_compensation_nm = 0;  ///< xy_hole_compensation: grows the holes, besides
  /// It stands on the bed itself: its first layer is first_layer_height high, and has a foot.
  bool on_bed = true;
  Coord elephant_foot_nm = 0;  ///< elefant_foot_compensation: shrinks the first layer on the bed
  /// Least width that the compensation leaves; PrusaSlicer: width + spacing of the first layer's
  /// outer wall.
  Coord elephant_foot_min_width_nm = 757'000;
  Coord lift_nm = 0;  ///< how high above the bed it will stand: the build volume holds that too
  /// spiral_vase: layers from this one on are hollow, and of their outlines the largest stays; 0:
  /// none are.
  int32_t hollow_from = 0;
  CounterboreBridging counterbores = CounterboreBridging::kNone;  ///< counterbore_hole_bridging
  AdaptiveHeights adaptive;
  /// layer_height_profile: heights by z, in between in proportion, instead of layer_height, ranges
  /// of heights and `adaptive`; upwards. None: by those.
  std::vector<LayerHeightAt> height_profile;

  friend bool operator==(const ObjectSlicingOptions&, const ObjectSlicingOptions&) = default;
};

/// Settings of a job that slicing needs.
struct JobSlicingOptions {
  Coord first_layer_height_nm = 200'000;  ///< first_layer_height: of what stands on the bed
  /// open_loop_max_gap: outlines with a hole up to this are closed over it, wider ones are dropped
  /// and counted.
  Coord max_gap_nm = 2'000'000;
  Coord resolution_nm = 5'000;  ///< outline_resolution: outlines are simplified to this tolerance
  /// bed_shape; empty: no limit.
  Polygon bed = {{0, 0}, {250'000'000, 0}, {250'000'000, 210'000'000}, {0, 210'000'000}};
  std::vector<Polygon> excluded = {};  ///< bed_exclude_area: parts of the bed where nothing may be
  Coord max_print_height_nm = 0;       ///< max_print_height, 0: unlimited
  std::vector<ThumbnailSize> thumbnails = {{32, 32}, {300, 300}};  ///< thumbnails
  Coord part_distance_nm = 6'000'000;  ///< duplicate_distance: between copies that are arranged
  /// Between copies that are arranged, where it is more: extruder_clearance_radius with
  /// complete_objects; with brims, part_distance_nm between these.
  Coord clearance_radius_nm = 0;

  friend bool operator==(const JobSlicingOptions&, const JobSlicingOptions&) = default;
};

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
