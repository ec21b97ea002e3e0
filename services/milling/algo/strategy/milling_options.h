#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "services/milling/algo/cutter/cutter.h"

namespace slicefarm::milling {

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

/// How the machine moves.
struct MachiningOptions {
  CutDirection direction = CutDirection::kClimb;
  EntryKind entry = EntryKind::kHelix;
  double ramp_angle_deg = 3;     ///< of ramps and helices
  double helix_radius_mm = 0;    ///< 0: half the cutter's radius
  double lead_in_radius_mm = 1;  ///< of arcs onto and off finishing ways; 0: none
  double safe_height_mm = 5;     ///< above the stock: where rapid moves are always free
  double clearance_mm = 0.5;     ///< between a rapid move and the stock that is left
  double feed_mm_min = 800;
  double plunge_feed_mm_min = 300;  ///< downwards, ramps and helices too
  double rapid_mm_min = 3000;       ///< of the machine: for times only
  int spindle_rpm = 12'000;
  Coolant coolant = Coolant::kOff;
  int tool_number = 1;
  double tool_length_mm = 0;  ///< below its holder; 0: not known, so not checked
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
  double sampling_mm = 0.2;          ///< distance of fibers
  double tolerance_mm = 0.01;        ///< between ways and those that touch the mesh exactly
  double stock_margin_mm = 1;        ///< of a box of stock around the part, at its sides and top
  std::optional<double> bottom_mm =
      std::nullopt;        ///< the tip goes no deeper; else down to the stock's bottom
  bool open_mesh = false;  ///< the part may be a surface that encloses nothing
  MachiningOptions machining = {};
  int threads = 1;

  double stepover_mm() const { return 2 * stepover_share * cutter.radius_mm(); }
};

/// SETTING_OUT_OF_RANGE, with `setting` and `got`, for the first number that cannot be.
absl::Status CheckMillingOptions(const MillingOptions& options);

}  // namespace slicefarm::milling
