#include "services/motion/algo/firmware/marlin.h"

#include "common/kinematics/marlin_planner.h"
#include "services/motion/algo/firmware/known_commands.h"
#include "services/motion/algo/firmware/limit_command.h"

namespace slicefarm::motion {
namespace {

// Commands of Marlin 2.1 and of Prusa's forks (G80, M74, M555, M572, M862 and others).
constexpr int kMarlinG[] = {0,  1,  2,  3,  4,  5,  6,  10, 11, 12, 17,  18, 19, 20,
                            21, 22, 26, 27, 28, 29, 30, 31, 32, 33, 34,  35, 38, 42,
                            53, 54, 55, 56, 57, 58, 59, 60, 61, 64, 76,  80, 81, 82,
                            83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 123, 425};
constexpr int kMarlinM[] = {
    0,   1,   3,   4,   5,   7,   8,   9,   10,  11,  16,  17,  18,  20,  21,  22,  23,  24,
    25,  26,  27,  28,  29,  30,  31,  32,  33,  34,  42,  43,  44,  48,  72,  73,  74,  75,
    76,  77,  78,  79,  80,  81,  82,  83,  84,  85,  86,  87,  92,  100, 102, 104, 105, 106,
    107, 108, 109, 110, 111, 112, 113, 114, 115, 117, 118, 119, 120, 121, 122, 123, 125, 126,
    127, 128, 129, 140, 141, 142, 143, 145, 149, 150, 154, 155, 163, 164, 165, 166, 190, 191,
    192, 193, 200, 201, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211, 214, 217, 218, 220,
    221, 226, 240, 250, 255, 256, 260, 261, 280, 281, 282, 290, 300, 301, 302, 303, 304, 305,
    306, 309, 310, 350, 351, 355, 360, 361, 362, 363, 364, 380, 381, 400, 401, 402, 403, 404,
    405, 406, 407, 410, 412, 413, 420, 421, 422, 423, 425, 428, 430, 486, 493, 494, 495, 496,
    497, 498, 500, 501, 502, 503, 504, 510, 511, 512, 524, 540, 552, 553, 554, 555, 569, 572,
    575, 591, 592, 593, 600, 601, 602, 603, 605, 665, 666, 672, 701, 702, 703, 704, 705, 706,
    707, 708, 709, 710, 808, 810, 811, 812, 813, 814, 815, 816, 817, 818, 819, 820, 851, 852,
    860, 861, 862, 863, 864, 865, 866, 867, 868, 869, 871, 876, 900, 906, 907, 908, 909, 910,
    911, 912, 913, 914, 915, 916, 917, 918, 919, 920, 928, 936, 951, 993, 994, 995, 997, 999};
constexpr KnownCommands kMarlinCommands{kMarlinG, kMarlinM};

constexpr double kMarlinArcSegmentMm = 1;

/// Travels use the acceleration of printing, because the firmware has only one for both. M204 has
/// the parameters of Prusa-Firmware: S sets the acceleration of moves, T that of retractions.
class LegacyFirmware : public MarlinFirmware {
 public:
  std::string_view name() const override { return "marlin"; }

  double AccelerationFor(const KinematicMove& move, const MachineLimits& limits) const override {
    if (move.ExtruderOnly()) return MarlinFirmware::AccelerationFor(move, limits);
    return AccelerationOr(limits.max_acceleration_extruding_mm_s2, 0);
  }
  bool HasTravelAcceleration() const override { return false; }
  bool HasJunctionDeviation() const override { return false; }
  void WriteAcceleration(double print_mm_s2, double /*travel_mm_s2*/,
                         GcodeText& out) const override {
    WriteM204(print_mm_s2, out);
  }

 protected:
  void WriteAccelerationLimits(const MachineLimits& limits, GcodeText& out) const override {
    LimitCommand("M204", out)
        .Set("S", limits.max_acceleration_extruding_mm_s2)
        .Set("T", limits.max_acceleration_retracting_mm_s2);
  }
  /// The rates are written even if they are 0, because the printer may have stored other values.
  void WriteLeastRates(const MachineLimits& limits, GcodeText& out) const override {
    LimitCommand("M205", out)
        .SetEven0("S", limits.min_extruding_rate_mm_s)
        .SetEven0("T", limits.min_travel_rate_mm_s);
  }
};

}  // namespace

std::unique_ptr<Planner> MarlinFirmware::MakePlanner(const MachineLimits& limits) const {
  return std::make_unique<MarlinPlanner>(limits);
}

double MarlinFirmware::AccelerationFor(const KinematicMove& move,
                                       const MachineLimits& limits) const {
  const double print = AccelerationOr(limits.max_acceleration_extruding_mm_s2, 0);
  if (move.ExtruderOnly()) return AccelerationOr(limits.max_acceleration_retracting_mm_s2, print);
  if (move.ratio[kE] != 0) return print;
  return AccelerationOr(limits.max_acceleration_travel_mm_s2, print);
}

double MarlinFirmware::ArcSegmentMm(double /*radius_mm*/, double /*speed_mm_s*/) const {
  return kMarlinArcSegmentMm;
}

bool MarlinFirmware::Knows(const GcodeLine& line) const { return kMarlinCommands.Contain(line); }

void MarlinFirmware::ApplyLimits(const GcodeLine& line, MachineLimits& limits) const {
  if (line.letter != 'M') return;
  if (line.number == 201) ReadAxes(line, 1, limits.max_acceleration_mm_s2);
  if (line.number == 203) ReadAxes(line, 1, limits.max_feedrate_mm_s);
  if (line.number == 204) ReadM204(line, limits);
  if (line.number == 205) {
    ReadAxes(line, 1, limits.max_jerk_mm_s);
    ReadLimit(line['J'], limits.junction_deviation_mm);
    ReadLimit(line['S'], limits.min_extruding_rate_mm_s);
    ReadLimit(line['T'], limits.min_travel_rate_mm_s);
  }
}

void MarlinFirmware::WriteLimits(const MachineLimits& limits, GcodeText& out) const {
  LimitCommand("M201", out).SetAxes(limits.max_acceleration_mm_s2);
  LimitCommand("M203", out).SetAxes(limits.max_feedrate_mm_s);
  WriteAccelerationLimits(limits, out);
  if (limits.junction_deviation_mm > 0) {
    LimitCommand("M205", out).Set("J", limits.junction_deviation_mm);
  } else {
    LimitCommand("M205", out).SetAxes(limits.max_jerk_mm_s);
  }
  WriteLeastRates(limits, out);
}

void MarlinFirmware::WriteLeastRates(const MachineLimits& limits, GcodeText& out) const {
  LimitCommand("M205", out)
      .Set("S", limits.min_extruding_rate_mm_s)
      .Set("T", limits.min_travel_rate_mm_s);
}

void MarlinFirmware::WriteAccelerationLimits(const MachineLimits& limits, GcodeText& out) const {
  LimitCommand("M204", out)
      .Set("P", limits.max_acceleration_extruding_mm_s2)
      .Set("R", limits.max_acceleration_retracting_mm_s2)
      .Set("T", limits.max_acceleration_travel_mm_s2);
}

void MarlinFirmware::WriteAcceleration(double print_mm_s2, double travel_mm_s2,
                                       GcodeText& out) const {
  WriteM204(print_mm_s2, travel_mm_s2, out);
}

void MarlinFirmware::WriteJerk(std::span<const double, 4> jerk_mm_s, GcodeText& out) const {
  LimitCommand("M205", out).Set("X", jerk_mm_s[kX]).Set("Y", jerk_mm_s[kY]);
}

void MarlinFirmware::WriteJunctionDeviation(double deviation_mm, GcodeText& out) const {
  LimitCommand("M205", out).Set("J", deviation_mm);
}

const Firmware& Marlin2() {
  static const MarlinFirmware firmware;
  return firmware;
}

const Firmware& MarlinLegacy() {
  static const LegacyFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
