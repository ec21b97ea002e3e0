#pragma once

#include <cstdint>

#include "common/geometry/point.h"
#include "common/model/options/fuzzy_options.h"

namespace slicefarm {

/// Algorithm that computes the walls.
enum class WallGenerator : uint8_t {
  kArachne,  ///< largest number of walls that fits, with widths that fill the island
  kClassic,  ///< walls of constant width, with gap fill where no wall fits
};

/// Islands or areas that have only one wall, with infill inside it.
enum class OneWallOnTop : uint8_t {
  kNowhere,
  kTopmost,   ///< islands of the object's last layer
  kSurfaces,  ///< areas without material above them; the inner walls are led around these areas
};

/// Parts of the infill's area that get gap fill because they are too narrow for infill lines.
enum class GapFillTarget : uint8_t {
  kEverywhere,
  kTopBottom,  ///< parts with nothing above or below them
  kNowhere,
};

/// Walls that get a rough surface.
enum class FuzzySkin : uint8_t {
  kNone,
  kContours,   ///< `fuzzy_skin = external`: the outermost walls of outer rings only
  kAllWalls,   ///< `fuzzy_skin = all`: the outermost walls of outer rings and of holes
  kEveryWall,  ///< `fuzzy_skin = allwalls`: inner walls too
};

/// Number of layers above and below a layer that kArachne reads to compute the layer's walls.
inline constexpr int32_t kBeadingHaloLayers = 2;

/// Options for the walls of one region. Member comments begin with the name of the setting.
struct BeadingOptions {
  WallGenerator generator = WallGenerator::kArachne;  ///< setting perimeter_generator
  int32_t perimeters = 3;                             ///< setting perimeters
  bool one_on_bed = false;                            ///< setting only_one_perimeter_first_layer
  OneWallOnTop one_on_top = OneWallOnTop::kNowhere;   ///< setting top_one_perimeter_type
  /// `alternate_extra_wall`: odd layers have one more wall
  bool alternate_extra = false;
  bool extra_perimeters = false;  ///< `extra_perimeters`: adds walls where a slope would have gaps
  FuzzySkin fuzzy = FuzzySkin::kNone;  ///< setting fuzzy_skin
  /// `fuzzy_skin_thickness`: largest displacement of points, inwards and outwards
  Coord fuzzy_thickness_nm = 300'000;
  /// `fuzzy_skin_point_dist`: average distance between displaced points
  Coord fuzzy_point_distance_nm = 800'000;
  FuzzyTexture texture = {};
  Coord external_width_nm = 450'000;  ///< setting external_perimeter_extrusion_width
  Coord inner_width_nm = 450'000;     ///< setting perimeter_extrusion_width
  /// `first_layer_extrusion_width`: width of all walls of layer 0
  Coord first_layer_width_nm = 450'000;
  bool gap_fill = true;                                   ///< setting gap_fill_enabled
  GapFillTarget gap_target = GapFillTarget::kEverywhere;  ///< setting gap_fill_target
  Coord min_gap_width_nm = 80'000;   ///< `gap_fill_min_width`: narrower gaps remain empty
  Coord min_gap_length_nm = 0;       ///< `gap_fill_min_length`: shorter gaps remain empty
  Coord max_gap_width_nm = 800'000;  ///< width above which the infill fills a gap
  bool thin_walls = true;  ///< `thin_walls`: used by kClassic; kArachne always prints thin walls
  /// Minimum length of thin-wall beads in islands that have walls, for kClassic. Shorter beads are
  /// left out. Set for supports, to drop the beads in their pointed ends.
  Coord least_tip_nm = 0;
  Coord transition_length_nm = 400'000;  ///< setting wall_transition_length
  /// `wall_transition_angle` in radians
  double transition_angle = 10 * 3.14159265358979323846 / 180;
  Coord transition_deviation_nm = 100'000;  ///< setting wall_transition_filter_deviation
  int32_t distribution_count = 1;           ///< setting wall_distribution_count
  Coord min_feature_nm = 100'000;           ///< setting min_feature_size
  Coord min_bead_width_nm = 340'000;        ///< setting min_bead_width
  Coord max_bead_width_nm = 800'000;        ///< setting max_bead_width
  /// `min_length_factor`: shorter open lines are left out, in widths of the outer wall
  double min_length_factor = 0;
  /// `wall_maximum_resolution` and `wall_maximum_deviation`: walls leave out points beside edges
  /// shorter than the first, as long as the walls move by at most the second
  Coord least_edge_nm = 500'000;
  Coord edge_deviation_nm = 5'000;
  bool lock_outer_width = false;  ///< setting lock_outer_width
  /// `precise_outer_wall`: the wall beside an outer wall is laid against it without pressing it
  /// outwards
  bool precise_outer = false;
  Coord min_top_width_nm = 0;  ///< `min_width_top_surface`: narrower top surfaces keep their walls
  /// `initial_layer_min_bead_width`: min_bead_width_nm of layer 0; 0: min_bead_width_nm
  Coord first_layer_min_bead_nm = 0;
  /// Class of the region. Regions of an object with the same class get their walls together, as if
  /// they were one region.
  int32_t wall_class = 0;

  friend bool operator==(const BeadingOptions&, const BeadingOptions&) = default;
};

}  // namespace slicefarm
