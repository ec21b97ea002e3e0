#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "common/base/shared/shared_text.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// Method of scanning the inside of an outline.
enum class ScanStrategy : uint8_t {
  kRings,        ///< convex pieces, each scanned by rings from its middle outwards
  kRingsInward,  ///< convex pieces, each scanned by rings from its border inwards
  kStripes,      ///< parallel stripes, each hatched across
  /// chequerboard of squares; the hatch lines of neighbouring squares are at right angles
  kIslands,
  kHatch,  ///< lines across the whole outline
};

/// Returns true if the strategy scans convex pieces by rings.
constexpr bool IsRings(ScanStrategy strategy) {
  return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
}

/// Method of cutting an outline into convex pieces.
enum class DecomposeMethod : uint8_t {
  kBian,     ///< method of Bian et al. 2005: well-shaped pieces, chosen by visibility and angles
  kOptimal,  ///< smallest possible number of pieces without new points (Greene); slow
  kApproximate,  ///< at most four times the minimum number of pieces (Hertel and Mehlhorn); fast
  kYMonotone,    ///< cut into y-monotone parts, then into convex pieces (Hertel and Mehlhorn); fast
};

/// Order of the pieces, stripes or islands.
enum class JumpOrder : uint8_t {
  kNearest,       ///< shortest path with the beam off
  kChequerboard,  ///< first every second block, then the rest, so that neighbours can cool down
  kFarthest,      ///< always the block farthest from the end of the previous one
  /// Start at the downstream end of the gas flow, so that smoke drifts over finished blocks.
  kAgainstGas,
};

/// Start point of contours.
enum class ContourStart : uint8_t {
  kScattered,  ///< different point in each layer, so that the part has no continuous seam
  kNearest,    ///< corner nearest to the beam's position
  kRear,       ///< corner farthest to the rear
};

/// Format of the output file.
enum class OutputFormat : uint8_t {
  kCliAscii,   ///< Common Layer Interface 2.0, text
  kCliBinary,  ///< Common Layer Interface 2.0 with binary geometry
  kGrbl,       ///< G-code of grbl 1.1: power by M4 S or M3 S
  kMarlin,     ///< G-code of Marlin 2 with inline power
  kSvg,        ///< SVG with one group per layer
  kDxf,        ///< DXF of a single layer
};

/// Purpose of a vector's exposure. Each kind has an ExposureStyle of its own.
enum class ExposureKind : uint8_t {
  kContour,
  kHatch,     ///< hatch lines and rings
  kUpskin,    ///< hatch lines with no part above
  kDownskin,  ///< hatch lines with powder below
  kThinWall,  ///< middle lines of areas too thin for a contour
};
inline constexpr int kExposureKindCount = 5;

/// Returns the name of a kind: "contour", "hatch", "upskin", "downskin" or "thin wall".
constexpr std::string_view ExposureKindName(ExposureKind kind) {
  constexpr std::array<std::string_view, kExposureKindCount> kNames = {"contour", "hatch", "upskin",
                                                                       "downskin", "thin wall"};
  return kNames[static_cast<size_t>(kind)];
}

/// Parameters of the beam. A pulsed beam (point_distance_nm > 0) exposes separate points; then the
/// point times and the jumps between points replace the speed.
struct ExposureStyle {
  double power_w = 200;
  double speed_mm_s = 800;
  double focus_mm = 0;       ///< height of the focal plane above the powder
  double frequency_khz = 0;  ///< pulse frequency; 0: continuous beam
  /// pulsed beam: distance between exposed points; 0: no separate points
  Coord point_distance_nm = 0;
  double point_time_us = 0;   ///< pulsed beam: exposure time of a point
  double point_delay_us = 0;  ///< pulsed beam: delay between two points

  friend bool operator==(const ExposureStyle&, const ExposureStyle&) = default;
};

/// Speed and delays of the scanner's jumps.
struct JumpOptions {
  double speed_mm_s = 5000;
  double delay_us = 0;          ///< delay after a jump until the mirrors stand still
  double mark_delay_us = 0;     ///< delay after each line until the beam is off
  double polygon_delay_us = 0;  ///< delay at each corner of a line

  friend bool operator==(const JumpOptions&, const JumpOptions&) = default;
};

/// Largest angle of gas_window_deg. With a larger window, a hatch line that is turned by 90 degrees
/// could still be in the window. For islands the largest window is half of this angle, because
/// their lines have two directions.
inline constexpr double kWidestGasWindowDeg = 45;

/// Options for scanning the sections of one region. The defaults are the defaults of PySLM; options
/// that PySLM lacks have the defaults of Netfabb.
struct ExposureOptions {
  ScanStrategy strategy = ScanStrategy::kStripes;
  DecomposeMethod decompose = DecomposeMethod::kBian;  ///< method used by the ring strategies
  JumpOrder jump_order = JumpOrder::kNearest;

  Coord hatch_distance_nm = 80'000;  ///< distance between lines and between rings
  Coord upskin_distance_nm = 0;      ///< line distance in upskins; 0: hatch_distance
  Coord downskin_distance_nm = 0;    ///< line distance in downskins; 0: hatch_distance
  double hatch_angle_deg = 45;       ///< angle of the hatch lines in layer 0
  double layer_rotation_deg = 67;    ///< turn of the hatch lines from each layer to the next
  bool alternate_directions = true;  ///< true: every second line runs backwards
  double gas_flow_deg = 0;           ///< direction towards which the gas flows, from the x axis
  /// Window around the gas flow. Hatch lines at a smaller angle to the flow, in either direction,
  /// are turned across the flow. They turn by 90 degrees; lines of islands turn by 45 degrees,
  /// because they have two directions.
  double gas_window_deg = 0;
  Coord minimum_vector_nm = 0;  ///< minimum length: shorter hatch lines and rings are left out

  Coord stripe_width_nm = 5'000'000;  ///< width of stripes
  Coord island_width_nm = 5'000'000;  ///< width of islands
  Coord overlap_nm = 100'000;         ///< overlap of neighbouring stripes or islands
  Coord ring_overlap_nm = 20'000;     ///< overlap of the outermost rings of neighbouring pieces
  bool link_rings = true;             ///< true: the beam stays on between the rings of a piece
  /// true: rings reach into corners that the round spot would otherwise leave unmelted
  bool fill_corners = true;

  // Options that move seams from layer to layer:
  /// true: shifts the lines and cells of hatch, stripes and islands from layer to layer
  bool shift_grids = true;
  /// true: moves the starts of rings and the cuts between pieces from layer to layer
  bool turn_rings = true;

  Coord spot_nm = 80'000;               ///< width of the melted line
  Coord beam_compensation_nm = 40'000;  ///< distance from the outline to the first contour
  int32_t contours = 2;
  /// Distance between contours, and from the last contour to rings.
  Coord contour_distance_nm = 80'000;
  Coord hatch_offset_nm = 40'000;  ///< distance from the last contour to the ends of hatch lines
  bool contours_first = true;
  ContourStart contour_start = ContourStart::kScattered;
  /// Length by which the scanner extends each contour and thin wall at both ends with the beam off.
  /// The beam then starts and ends at full speed.
  Coord contour_run_nm = 0;
  /// True: areas too thin for a contour are exposed once along their middle.
  bool thin_walls = true;

  /// A hatched area is upskin if one of this many layers above it has no part there; 0: no upskins.
  int32_t upskin_layers = 0;
  /// A hatched area is downskin if one of this many layers below it has powder there; 0: no
  /// downskins.
  int32_t downskin_layers = 0;
  Coord skin_overlap_nm = 0;  ///< length by which skins extend into the neighbouring hatch

  /// Number of layers below the current layer that the beam melts as well. Areas where any of these
  /// layers has no part are not exposed.
  int32_t z_compensation_layers = 0;

  /// Skywriting: length by which the scanner extends each hatch line at both ends with the beam
  /// off. The line itself is scanned at full speed. The paths get longer, but need no mark delay.
  Coord skywriting_nm = 0;

  std::array<ExposureStyle, kExposureKindCount> styles;  ///< styles per ExposureKind
  JumpOptions jump;

  const ExposureStyle& StyleOf(ExposureKind kind) const {
    return styles[static_cast<size_t>(kind)];
  }
  /// Returns the number of layers above and below on which the exposure of a section depends.
  int32_t Halo() const { return std::max(upskin_layers, downskin_layers + z_compensation_layers); }
  /// Returns the distance between the lines of a kind. Skins may have a distance of their own.
  Coord HatchDistanceNm(ExposureKind kind) const {
    const Coord own = kind == ExposureKind::kUpskin     ? upskin_distance_nm
                      : kind == ExposureKind::kDownskin ? downskin_distance_nm
                                                        : 0;
    return own > 0 ? own : hatch_distance_nm;
  }
  friend bool operator==(const ExposureOptions&, const ExposureOptions&) = default;
};

/// Output options of a job.
struct ExposureOutput {
  OutputFormat format = OutputFormat::kCliAscii;
  int32_t layer = 0;          ///< DXF: layer that the file contains
  double unit_mm = 0.001;     ///< CLI: unit of the coordinates ($$UNITS)
  double full_power_w = 400;  ///< G-code: laser power at the S value `full_power_s`
  double full_power_s = 1000;
  /// G-code of grbl: true to use M4, which reduces the power when the head is slower
  bool dynamic_power = true;
  double recoat_s = 0;  ///< time before each layer for new powder or resin
  /// G-code: templates. They are inserted before all layers, before each layer's move in z, after
  /// this move, and after all layers.
  SharedText start_gcode = {}, before_layer_gcode = {}, layer_gcode = {}, end_gcode = {};

  friend bool operator==(const ExposureOutput&, const ExposureOutput&) = default;
};

}  // namespace slicefarm
