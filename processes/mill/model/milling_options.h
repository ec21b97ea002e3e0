#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "common/model/options/cutter.h"
#include "common/model/process.h"

namespace slicefarm {

/// Which side of the cutter meets the stock, as seen from a spindle that turns clockwise.
enum class CutDirection : uint8_t {
  kClimb,         ///< the stock on the right of the way
  kConventional,  ///< on the left
};

/// How the cutter goes down into stock.
enum class EntryKind : uint8_t {
  kHelix,   ///< where a circle fits beside the way, else as a ramp
  kRamp,    ///< along the way
  kPlunge,  ///< straight
};

enum class Coolant : uint8_t { kOff, kMist, kFlood };

/// Which controller reads the program.
enum class MillDialect : uint8_t { kLinuxCnc, kGrbl };

/// Where X0 Y0 Z0 of a program are.
enum class MillOrigin : uint8_t {
  kModel,     ///< where the first object's file has them
  kBed,       ///< the bed's corner, and its top
  kStockTop,  ///< the corner of the stock's box with the least x and y, at its top
};

/// What a job's file holds.
enum class MillFormat : uint8_t {
  kGcode,
  kSvg,  ///< a picture of one step
};

/// How the machine moves. Names in the comments are the settings'.
struct MachiningOptions {
  CutDirection direction = CutDirection::kClimb;
  EntryKind entry = EntryKind::kHelix;
  double ramp_angle_deg = 3;     ///< of ramps and helices
  double helix_radius_mm = 0;    ///< 0: half the cutter's radius
  double lead_in_radius_mm = 1;  ///< of arcs onto and off finishing ways; 0: none
  bool arcs = true;              ///< G2 and G3; else lines alone
  double safe_height_mm = 5;     ///< above the stock: where rapid moves are always free
  double clearance_mm = 0.5;     ///< between a rapid move and the stock that is left
  double feed_mm_min = 800;
  double plunge_feed_mm_min = 300;  ///< downwards, ramps and helices too
  double rapid_mm_min = 3000;       ///< the machine's fastest: for times only
  int spindle_rpm = 12'000;
  Coolant coolant = Coolant::kOff;
  int tool_number = 1;
  double tool_length_mm = 0;  ///< below its holder; 0: not known, so not checked

  /// machine_max_acceleration_x, _y, _z
  std::array<double, 3> max_acceleration_mm_s2 = {500, 500, 300};
  double jerk_mm_s3 = 20'000;  ///< jerk_limit: change of acceleration
  bool corner_feeds = false;   ///< feeds are lowered to what these limits allow

  friend bool operator==(const MachiningOptions&, const MachiningOptions&) = default;
};

/// All that decides a milling program, besides part and stock.
struct MillingOptions {
  Cutter cutter;
  double stepdown_mm = 1;          ///< most between two levels of roughing
  double stepover_share = 0.4;     ///< of the diameter: between two ways of a level; at most half
  double allowance_mm = 0.2;       ///< what roughing leaves around the part, for finishing
  double minimum_width_mm = 0.05;  ///< ways for the tip narrower than this are left to finishing
  bool finishing = true;
  double finish_stepdown_mm = 0.25;  ///< most between two waterlines
  double finish_stepover_mm = 0.25;  ///< between parallel ways
  double rest_angle_deg = 45;        ///< flatter than this the part is finished by parallel ways
  bool finish_floor = false;         ///< the stock's floor beside the part, too
  double sampling_mm = 0.1;          ///< distance of fibers
  double tolerance_mm = 0.01;        ///< between ways and those that touch the mesh exactly
  double stock_margin_mm = 1;        ///< of a box of stock around the part, at its sides and top
  double bottom_mm = 0;              ///< the tip stays as high above the stock's bottom
  bool open_mesh = false;            ///< the part may be a surface that encloses nothing
  MachiningOptions machining = {};

  double stepover_mm() const { return 2 * stepover_share * cutter.radius_mm(); }

  friend bool operator==(const MillingOptions&, const MillingOptions&) = default;
};

/// What milling a job is made with.
struct MillSettings {
  static constexpr Process kProcess = Process::kMill;

  MillingOptions how;
  std::string stock;  ///< the object that is the stock; empty: a box around the others
  MillOrigin origin = MillOrigin::kModel;
  MillDialect dialect = MillDialect::kLinuxCnc;
  MillFormat format = MillFormat::kGcode;
  int32_t output_step = 0;  ///< of a picture, from 0

  friend bool operator==(const MillSettings&, const MillSettings&) = default;
};

/// Returns the settings of a job (JobSettings, JobRows), which has none by object or region.
/// REQUIRES: the job is of that process.
template <typename Job>
auto& MillOf(Job& job) {
  return job.own.template As<MillSettings>();
}

}  // namespace slicefarm
