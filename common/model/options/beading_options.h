#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

enum class WallGenerator : uint8_t {
  kArachne,  ///< as many walls as fit, as wide as makes them fill the place
  kClassic,  ///< walls of constant width, with gap fill where they do not fit
};

/// Where an island has one wall alone, and infill inside it.
enum class OneWallOnTop : uint8_t {
  kNowhere,
  kTopmost,   ///< in the object's last layer
  kSurfaces,  ///< wherever nothing lies above: the inner walls go round it
};

/// Which walls get a rough skin.
enum class FuzzySkin : uint8_t {
  kNone,
  kContours,  ///< external: the outermost walls of outer rings
  kAllWalls,  ///< all: those of holes, too
};

/// Walls of kArachne depend on so many layers above and below.
inline constexpr int32_t kBeadingHaloLayers = 2;

struct BeadingOptions {
  WallGenerator generator = WallGenerator::kArachne;  ///< perimeter_generator
  int32_t perimeters = 3;                             ///< perimeters
  bool one_on_bed = false;                            ///< only_one_perimeter_first_layer
  OneWallOnTop one_on_top = OneWallOnTop::kNowhere;   ///< top_one_perimeter_type
  bool extra_perimeters = false;  ///< extra_perimeters: more walls where a slope would show gaps
  FuzzySkin fuzzy = FuzzySkin::kNone;  ///< fuzzy_skin
  Coord fuzzy_thickness_nm = 300'000;  ///< fuzzy_skin_thickness: how far points move, both ways
  Coord fuzzy_point_distance_nm = 800'000;  ///< fuzzy_skin_point_dist: on average
  Coord external_width_nm = 450'000;        ///< external_perimeter_extrusion_width
  Coord inner_width_nm = 450'000;           ///< perimeter_extrusion_width
  Coord first_layer_width_nm = 450'000;  ///< first_layer_extrusion_width, for all walls of layer 0
  bool gap_fill = true;                  ///< gap_fill_enabled
  Coord min_gap_width_nm = 80'000;       ///< gap_fill_min_width: narrower gaps stay empty
  Coord max_gap_width_nm = 800'000;      ///< wider gaps are the infill's
  bool thin_walls = true;                ///< thin_walls: of kClassic; kArachne always prints them
  /// Of kClassic: beside a wall, beads of thin walls shorter than this stay out: tips of supports.
  Coord least_tip_nm = 0;
  Coord transition_length_nm = 400'000;  ///< wall_transition_length
  double transition_angle = 10 * 3.14159265358979323846 / 180;  ///< wall_transition_angle, radians
  Coord transition_deviation_nm = 100'000;  ///< wall_transition_filter_deviation
  int32_t distribution_count = 1;           ///< wall_distribution_count
  Coord min_feature_nm = 100'000;           ///< min_feature_size
  Coord min_bead_width_nm = 340'000;        ///< min_bead_width
  Coord max_bead_width_nm = 800'000;        ///< max_bead_width
  bool lock_outer_width = false;            ///< lock_outer_width
  /// Regions of an object that are equal in this get their walls together, as if they were one.
  int32_t wall_class = 0;

  friend bool operator==(const BeadingOptions&, const BeadingOptions&) = default;
};

}  // namespace slicefarm
