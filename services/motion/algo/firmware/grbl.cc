#include "services/motion/algo/firmware/grbl.h"

#include "common/kinematics/marlin_planner.h"
#include "services/motion/algo/firmware/known_commands.h"

namespace slicefarm::motion {
namespace {

// Commands of grbl 1.1, doc/markdown/commands.md. G38 and G59 include their decimals.
constexpr int kGrblG[] = {0,  1,  2,  3,  4,  10, 17, 18, 19, 20, 21, 28, 30, 38, 40, 43,
                          49, 53, 54, 55, 56, 57, 58, 59, 61, 80, 90, 91, 92, 93, 94};
constexpr int kGrblM[] = {0, 1, 2, 3, 4, 5, 7, 8, 9, 30, 56};
constexpr KnownCommands kGrblCommands{kGrblG, kGrblM};

/// grbl's default value of $11.
constexpr double kJunctionDeviationMm = 0.01;
constexpr double kGrblArcSegmentMm = 1;

class GrblFirmware : public Firmware {
 public:
  std::string_view name() const override { return "grbl"; }

  /// grbl uses Marlin's junction deviation.
  std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const override {
    MachineLimits with_deviation = limits;
    if (with_deviation.junction_deviation_mm <= 0)
      with_deviation.junction_deviation_mm = kJunctionDeviationMm;
    return std::make_unique<MarlinPlanner>(with_deviation);
  }
  double AccelerationFor(const KinematicMove& /*move*/,
                         const MachineLimits& limits) const override {
    return limits.max_acceleration_mm_s2[0];
  }
  double ArcSegmentMm(double /*radius_mm*/, double /*speed_mm_s*/) const override {
    return kGrblArcSegmentMm;
  }

  ExtruderMode extruder_mode() const override { return ExtruderMode::kApart; }
  bool Knows(const GcodeLine& line) const override { return kGrblCommands.Contain(line); }
  /// The limits are settings of the controller ($110 to $122), not commands.
  void ApplyLimits(const GcodeLine& /*line*/, MachineLimits& /*limits*/) const override {}

  void WriteLimits(const MachineLimits& /*limits*/, GcodeText& /*out*/) const override {}
  bool HasTravelAcceleration() const override { return false; }
  void WriteAcceleration(double /*print*/, double /*travel*/, GcodeText& /*out*/) const override {}
  void WriteJerk(std::span<const double, 4> /*jerk*/, GcodeText& /*out*/) const override {}
  void WritePressureAdvance(double /*value*/, GcodeText& /*out*/) const override {}
  std::string LabelOf(std::string_view name, size_t /*index*/) const override {
    return std::string(name);
  }
  void DefineCopies(std::span<const CopySummary> /*copies*/,
                    std::span<const std::string> /*labels*/, GcodeText& /*out*/) const override {}
  void BeginCopy(std::string_view /*label*/, size_t /*index*/, GcodeText& /*out*/) const override {}
  void EndCopy(std::string_view /*label*/, size_t /*index*/, GcodeText& /*out*/) const override {}
};

}  // namespace

const Firmware& Grbl() {
  static const GrblFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
