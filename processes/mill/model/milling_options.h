#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "common/model/options/cutter.h"
#include "common/model/process.h"

namespace slicefarm {

/// Side of the toolpath on which the stock is, for a spindle that turns clockwise.
enum class CutDirection : uint8_t {
  kClimb,         ///< stock on the right of the toolpath
  kConventional,  ///< stock on the left of the toolpath
};

/// Motion by which the cutter enters the stock.
enum class EntryKind : uint8_t {
  kHelix,   ///< helix if a circle fits beside the toolpath, otherwise a ramp
  kRamp,    ///< ramp along the toolpath
  kPlunge,  ///< vertical move
};

/// Coolant that the machine applies.
enum class Coolant : uint8_t { kOff, kMist, kFlood };

/// Controller that reads the program.
enum class MillDialect : uint8_t { kLinuxCnc, kGrbl };

/// Position of X0 Y0 Z0 of a program.
enum class MillOrigin : uint8_t {
  kModel,     ///< origin of the first object's file
  kBed,       ///< corner of the bed, at its top
  kStockTop,  ///< corner of the stock's bounding box with the smallest x and y, at its top
};

/// Content of a job's output file.
enum class MillFormat : uint8_t {
  kGcode,
  kSvg,  ///< picture of one step
};

/// Options of the machine's moves. Names in the comments are names of settings.
struct MachiningOptions {
  CutDirection direction = CutDirection::kClimb;
  EntryKind entry = EntryKind::kHelix;
  double ramp_angle_deg = 3;     ///< angle of ramps and helices to the horizontal
  double helix_radius_mm = 0;    ///< radius of entry helices; 0: half the cutter's radius
  double lead_in_radius_mm = 1;  ///< radius of arcs onto and off finishing toolpaths; 0: no arcs
  bool arcs = true;              ///< true: writes arcs as G2 and G3; false: only lines
  double safe_height_mm = 5;     ///< height above the stock at which rapid moves are always free
  double clearance_mm = 0.5;     ///< distance between a rapid move and the remaining stock
  double feed_mm_min = 800;
  double plunge_feed_mm_min = 300;  ///< feed of downward moves, ramps and helices included
  double rapid_mm_min = 3000;       ///< the machine's maximum speed; used only for times
  int spindle_rpm = 12'000;
  Coolant coolant = Coolant::kOff;
  int tool_number = 1;
  double tool_length_mm = 0;  ///< length of the tool below its holder; 0: unknown, so not checked

  /// `machine_max_acceleration_x`, _y, _z
  std::array<double, 3> max_acceleration_mm_s2 = {500, 500, 300};
  double jerk_mm_s3 = 20'000;  ///< `jerk_limit`: maximum change of acceleration
  /// True: reduces feeds to the values that the acceleration and jerk limits allow.
  bool corner_feeds = false;

  friend bool operator==(const MachiningOptions&, const MachiningOptions&) = default;
};

/// Options that determine a milling program, besides part and stock.
struct MillingOptions {
  Cutter cutter;
  double stepdown_mm = 1;  ///< largest distance between two levels of roughing
  /// Distance between a level's toolpaths, as a share of the cutter's diameter; at most half.
  double stepover_share = 0.4;
  /// Thickness of stock that roughing leaves around the part for finishing.
  double allowance_mm = 0.2;
  /// smallest width of an area of tip positions that roughing mills; a passage must be wider than
  /// the cutter by this amount, narrower passages are left to finishing; 0: no limit
  double minimum_width_mm = 0.05;
  bool finishing = true;
  double finish_stepdown_mm = 0.25;  ///< largest distance between two waterlines
  double finish_stepover_mm = 0.25;  ///< distance between parallel toolpaths
  double rest_angle_deg = 45;  ///< slope below which the part is finished by parallel toolpaths
  bool finish_floor = false;   ///< true: finishes the stock's floor beside the part, too
  /// distance between fibers, the horizontal lines along which the cutter is pushed to find
  /// waterlines
  double sampling_mm = 0.1;
  /// largest distance between a toolpath and exact contact with the mesh
  double tolerance_mm = 0.01;
  double stock_margin_mm = 1;  ///< margin of a stock box around the part, at its sides and top
  double bottom_mm = 0;        ///< smallest height of the tip above the stock's bottom
  bool open_mesh = false;      ///< true: the part may be an open surface
  MachiningOptions machining = {};

  double stepover_mm() const { return 2 * stepover_share * cutter.radius_mm(); }

  friend bool operator==(const MillingOptions&, const MillingOptions&) = default;
};

/// Settings of a milling job.
struct MillSettings {
  static constexpr Process kProcess = Process::kMill;

  MillingOptions how;
  std::string stock;  ///< name of the object that is the stock; empty: a box around all objects
  MillOrigin origin = MillOrigin::kModel;
  MillDialect dialect = MillDialect::kLinuxCnc;
  MillFormat format = MillFormat::kGcode;
  int32_t output_step = 0;  ///< step that a picture shows, from 0

  friend bool operator==(const MillSettings&, const MillSettings&) = default;
};

/// Returns the milling settings of a job (JobSettings, JobRows). Milling has no settings per object
/// or region. REQUIRES: the job is a milling job.
template <typename Job>
auto& MillOf(Job& job) {
  return job.own.template As<MillSettings>();
}

}  // namespace slicefarm
