#include "services/motion/algo/firmware/reprap.h"

#include <algorithm>
#include <cmath>

#include "common/kinematics/reprap_planner.h"
#include "services/motion/algo/firmware/known_commands.h"
#include "services/motion/algo/firmware/limit_command.h"
#include "services/motion/algo/firmware/numbered_objects.h"

namespace slicefarm::motion {
namespace {

constexpr int kRepRapG[] = {0,  1,  2,  3,  4,  10, 11, 17, 18, 19, 20, 21, 28, 29, 30, 31, 32,
                            38, 53, 54, 55, 56, 57, 58, 59, 60, 68, 69, 90, 91, 92, 93, 94};
constexpr int kRepRapM[] = {
    0,   1,   2,   3,   4,   5,   17,  18,  20,  21,  22,  23,  24,  25,  26,  27,  28,  29,  30,
    32,  36,  37,  38,  39,  42,  73,  80,  81,  82,  83,  84,  85,  92,  98,  99,  101, 102, 103,
    104, 105, 106, 107, 108, 109, 110, 111, 112, 114, 115, 116, 117, 118, 119, 120, 121, 122, 140,
    141, 143, 144, 150, 190, 191, 200, 201, 203, 204, 205, 206, 207, 208, 220, 221, 226, 260, 261,
    280, 290, 291, 292, 300, 301, 302, 303, 304, 305, 307, 308, 309, 350, 374, 375, 376, 400, 401,
    402, 404, 407, 408, 409, 425, 450, 451, 452, 453, 470, 471, 472, 486, 500, 501, 502, 503, 505,
    540, 550, 551, 552, 553, 554, 555, 556, 557, 558, 559, 560, 561, 562, 563, 564, 566, 567, 568,
    569, 570, 571, 572, 574, 575, 576, 577, 579, 581, 582, 584, 585, 586, 587, 588, 589, 591, 592,
    593, 594, 595, 596, 597, 598, 599, 600, 601, 606, 665, 666, 667, 669, 670, 671, 672, 673, 674,
    675, 701, 702, 703, 750, 751, 752, 753, 754, 755, 756, 851, 905, 906, 911, 912, 913, 915, 916,
    917, 918, 929, 950, 951, 952, 953, 954, 955, 956, 957, 997, 998, 999};
constexpr KnownCommands kRepRapCommands{kRepRapG, kRepRapM};

constexpr double kPerMinute = 1.0 / 60;
// Limits for the chords of an arc: the largest deviation from the arc, and the largest number of
// chords per second.
constexpr double kArcDeviationMm = 0.005;
constexpr double kArcSegmentsPerSecond = 200;
constexpr double kShortestArcSegmentMm = 0.02;
constexpr double kLongestArcSegmentMm = 1;

class RepRapFirmware : public NumberedObjects {
 public:
  std::string_view name() const override { return "reprapfirmware"; }

  std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const override {
    return std::make_unique<RepRapPlanner>(limits);
  }
  double AccelerationFor(const KinematicMove& move, const MachineLimits& limits) const override {
    const double print = AccelerationOr(limits.max_acceleration_extruding_mm_s2, 0);
    if (move.ratio[kE] > 0) return print;
    return AccelerationOr(limits.max_acceleration_travel_mm_s2, print);
  }
  double ArcSegmentMm(double radius_mm, double speed_mm_s) const override {
    return std::clamp(
        std::min(std::sqrt(8 * radius_mm * kArcDeviationMm), speed_mm_s / kArcSegmentsPerSecond),
        kShortestArcSegmentMm, kLongestArcSegmentMm);
  }

  ExtruderMode extruder_mode() const override { return ExtruderMode::kApart; }
  bool Knows(const GcodeLine& line) const override { return kRepRapCommands.Contain(line); }
  bool HasLists() const override { return true; }

  void ApplyLimits(const GcodeLine& line, MachineLimits& limits) const override {
    if (line.letter != 'M') return;
    if (line.number == 201) ReadAxes(line, 1, limits.max_acceleration_mm_s2);
    if (line.number == 203) ReadAxes(line, kPerMinute, limits.max_feedrate_mm_s);
    if (line.number == 205) ReadAxes(line, 1, limits.max_jerk_mm_s);
    if (line.number == 566) ReadAxes(line, kPerMinute, limits.max_jerk_mm_s);
    if (line.number == 204) ReadM204(line, limits);
  }

  /// Source: the Duet's G-code dictionary, M567.
  void WriteMix(std::span<const double> shares, GcodeText& out) const override {
    out << "M567 P0 E";
    for (size_t i = 0; i < shares.size(); ++i) {
      if (i > 0) out << ':';
      out.Real(shares[i], 3);
    }
    out << '\n';
  }

  void WriteLimits(const MachineLimits& limits, GcodeText& out) const override {
    LimitCommand("M201", out).SetAxes(limits.max_acceleration_mm_s2);
    LimitCommand("M203", out).SetAxes(limits.max_feedrate_mm_s, 1 / kPerMinute);
    LimitCommand("M204", out)
        .Set("P", limits.max_acceleration_extruding_mm_s2)
        .Set("T", limits.max_acceleration_travel_mm_s2);
    LimitCommand("M566", out).SetAxes(limits.max_jerk_mm_s, 1 / kPerMinute);
  }
  /// Writes the values that the printer's file list shows, under its own keys.
  void WriteHead(const PrintFacts& facts, GcodeText& out) const override {
    out << "; num_layers = ";
    out.Integer(facts.layers) << "\n; max_z_height = ";
    out.Real(facts.height_mm, 3) << '\n';
  }
  void WritePressureAdvance(double value, GcodeText& out) const override {
    out << "M572 D0 S";
    out.Real(value, 5) << '\n';
  }
  bool HasTravelAcceleration() const override { return true; }
  void WriteAcceleration(double print_mm_s2, double travel_mm_s2, GcodeText& out) const override {
    WriteM204(print_mm_s2, travel_mm_s2, out);
  }
  void WriteJerk(std::span<const double, 4> jerk_mm_s, GcodeText& out) const override {
    LimitCommand("M566", out)
        .Set("X", jerk_mm_s[kX] / kPerMinute)
        .Set("Y", jerk_mm_s[kY] / kPerMinute);
  }
};

}  // namespace

const Firmware& RepRap() {
  static const RepRapFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
