#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "common/base/shared/shared_text.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// How the inside of an outline is scanned.
enum class ScanStrategy : uint8_t {
  kRings,        ///< convex pieces, each by rings from its middle outwards
  kRingsInward,  ///< the same from its border inwards
  kStripes,      ///< parallel stripes, each hatched across
  kIslands,      ///< a chequerboard of squares, hatched by turns along and across
  kHatch,        ///< lines right through
};

constexpr bool IsRings(ScanStrategy strategy) {
  return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
}

/// How an outline is cut into convex pieces.
enum class DecomposeMethod : uint8_t {
  kBian,         ///< Bian et al. 2005: good shapes, by visibility and angles
  kOptimal,      ///< fewest pieces without new points (Greene); slow
  kApproximate,  ///< at most four times as many (Hertel and Mehlhorn); fast
  kYMonotone,    ///< y-monotone parts, each cut into convex ones (Hertel and Mehlhorn); fast
};

/// Which piece, stripe or island comes after which.
enum class JumpOrder : uint8_t {
  kNearest,       ///< least way with the beam off
  kChequerboard,  ///< first every other one, then the rest: neighbours cool down between
  kFarthest,      ///< as far as can be from what was scanned before
  kAgainstGas,    ///< from where the gas flows to: smoke blows over what is done
};

/// Where contours begin and end.
enum class ContourStart : uint8_t {
  kScattered,  ///< elsewhere in each layer, so that no seam runs up the part
  kNearest,    ///< at the corner nearest to where the beam is
  kRear,       ///< at the corner farthest back
};

enum class OutputFormat : uint8_t {
  kCliAscii,   ///< Common Layer Interface 2.0
  kCliBinary,  ///< the same with binary geometry
  kGrbl,       ///< G-code of grbl 1.1: power by M4 S, or M3 S
  kMarlin,     ///< G-code of Marlin 2 with inline power
  kSvg,        ///< a group a layer
  kDxf,        ///< one layer only
};

/// What a vector is exposed for. Each kind has a style of its own.
enum class ExposureKind : uint8_t {
  kContour,
  kHatch,     ///< rings too
  kUpskin,    ///< hatch with nothing above
  kDownskin,  ///< hatch with powder below
  kThinWall,  ///< too thin for a contour: one exposure along its middle
};
inline constexpr int kExposureKindCount = 5;

/// "contour", "hatch", "upskin", "downskin", "thin wall".
constexpr std::string_view ExposureKindName(ExposureKind kind) {
  constexpr std::array<std::string_view, kExposureKindCount> kNames = {"contour", "hatch", "upskin",
                                                                       "downskin", "thin wall"};
  return kNames[static_cast<size_t>(kind)];
}

/// How the beam draws. A pulsed one (point_distance_nm > 0) draws points: their time and the way
/// between them replace the speed.
struct ExposureStyle {
  double power_w = 200;
  double speed_mm_s = 800;
  double focus_mm = 0;          ///< of the focal plane, above the powder
  double frequency_khz = 0;     ///< 0: continuous
  Coord point_distance_nm = 0;  ///< pulsed: from point to point
  double point_time_us = 0;     ///< pulsed: exposure of a point
  double point_delay_us = 0;    ///< pulsed: between two points

  friend bool operator==(const ExposureStyle&, const ExposureStyle&) = default;
};

/// What the scanner waits for, and how fast it jumps.
struct JumpOptions {
  double speed_mm_s = 5000;
  double delay_us = 0;          ///< after a jump, until the mirrors rest
  double mark_delay_us = 0;     ///< after each line, until the beam is off
  double polygon_delay_us = 0;  ///< at each corner of a line

  friend bool operator==(const JumpOptions&, const JumpOptions&) = default;
};

/// Within this of the gas's direction a quarter turn takes a line out of the window for sure; half
/// of it for islands, whose lines run both ways.
inline constexpr double kWidestGasWindowDeg = 45;

/// How the sections of one region are scanned. Defaults are those of PySLM, and Netfabb's where
/// PySLM has none.
struct ExposureOptions {
  ScanStrategy strategy = ScanStrategy::kStripes;
  DecomposeMethod decompose = DecomposeMethod::kBian;  ///< of rings
  JumpOrder jump_order = JumpOrder::kNearest;

  Coord hatch_distance_nm = 80'000;  ///< between lines, and between rings
  Coord upskin_distance_nm = 0;      ///< between lines of upskins; 0: hatch_distance
  Coord downskin_distance_nm = 0;    ///< between lines of downskins; 0: hatch_distance
  double hatch_angle_deg = 45;       ///< of layer 0
  double layer_rotation_deg = 67;    ///< from each layer to the next
  bool alternate_directions = true;  ///< every other line backwards
  double gas_flow_deg = 0;           ///< where the gas flows to, from the x axis
  /// Hatch lines that run with or against the flow, but for this, run across it: at 90 degrees to
  /// their own direction; at 45 if they are islands', which have lines both ways.
  double gas_window_deg = 0;
  Coord minimum_vector_nm = 0;  ///< shorter hatch lines and rings are left out

  Coord stripe_width_nm = 5'000'000;  ///< of stripes
  Coord island_width_nm = 5'000'000;  ///< of islands
  Coord overlap_nm = 100'000;         ///< of neighbouring stripes or islands
  Coord ring_overlap_nm = 20'000;     ///< of neighbouring pieces' outermost rings
  bool link_rings = true;             ///< rings of a piece without switching off between them
  bool fill_corners = true;           ///< rings reach into corners that a round spot leaves open

  // Seams elsewhere in each layer:
  bool shift_grids = true;  ///< the lines and cells of hatch, stripes and islands move
  bool turn_rings = true;   ///< rings begin, and outlines are cut into pieces, at other places

  Coord spot_nm = 80'000;               ///< width of what a line melts
  Coord beam_compensation_nm = 40'000;  ///< from the outline to the first contour
  int32_t contours = 2;
  Coord contour_distance_nm = 80'000;  ///< between contours, and from the last one to rings
  Coord hatch_offset_nm = 40'000;      ///< from the last contour to the ends of hatch lines
  bool contours_first = true;
  ContourStart contour_start = ContourStart::kScattered;
  /// The scanner comes to and leaves each contour and thin wall on this length along its direction,
  /// with the beam off, so that the beam begins and ends at full speed.
  Coord contour_run_nm = 0;
  bool thin_walls = true;  ///< what is too thin for a contour is exposed once along its middle

  int32_t upskin_layers = 0;    ///< upskin: no part this many layers above; 0: none
  int32_t downskin_layers = 0;  ///< downskin: powder within this many layers below; 0: none
  Coord skin_overlap_nm = 0;    ///< how far skins reach into the rest

  /// The beam melts this many layers deeper than the one it draws on: where so many layers below
  /// are not all part, nothing is exposed.
  int32_t z_compensation_layers = 0;

  /// The scanner runs up and out on this length beyond each hatch line with the beam off, so that
  /// it draws at full speed. Longer way, and no mark delay.
  Coord skywriting_nm = 0;

  std::array<ExposureStyle, kExposureKindCount> styles;  ///< by ExposureKind
  JumpOptions jump;

  const ExposureStyle& StyleOf(ExposureKind kind) const {
    return styles[static_cast<size_t>(kind)];
  }
  /// How many layers above and below a section its exposure depends on.
  int32_t Halo() const { return std::max(upskin_layers, downskin_layers + z_compensation_layers); }
  /// Of vectors of that kind: skins may have one of their own.
  Coord HatchDistanceNm(ExposureKind kind) const {
    const Coord own = kind == ExposureKind::kUpskin     ? upskin_distance_nm
                      : kind == ExposureKind::kDownskin ? downskin_distance_nm
                                                        : 0;
    return own > 0 ? own : hatch_distance_nm;
  }
  friend bool operator==(const ExposureOptions&, const ExposureOptions&) = default;
};

/// What the file looks like. One a job.
struct ExposureOutput {
  OutputFormat format = OutputFormat::kCliAscii;
  int32_t layer = 0;          ///< of DXF: which one
  double unit_mm = 0.001;     ///< of CLI coordinates ($$UNITS)
  double full_power_w = 400;  ///< G-code: at `full_power_s`
  double full_power_s = 1000;
  bool dynamic_power = true;  ///< G-code of grbl: M4, less power where the head is slower
  double recoat_s = 0;        ///< before each layer: until there is new powder or resin
  /// Of G-code: templates before all layers, before and after each layer's move in Z, after all.
  SharedText start_gcode = {}, before_layer_gcode = {}, layer_gcode = {}, end_gcode = {};

  friend bool operator==(const ExposureOutput&, const ExposureOutput&) = default;
};

}  // namespace slicefarm
