#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "common/kinematics/kinematic_move.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/program/heat_waits.h"
#include "services/motion/algo/text/gcode_line.h"
#include "services/motion/algo/toolpath/arc_chords.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Properties of the printer on which the meaning of a program depends.
struct MachineSetup {
  MachineLimits limits;
  RetractionOptions retraction;  ///< retraction of G10 and G11, until M207
  HeatingRates heating;
  /// Diameter if E is in mm3 of filament; 0: E is in mm; until M200.
  double volume_diameter_mm = 0;
  double arc_segment_mm = 0;  ///< length of the chords of arcs; 0: the firmware's own
};

/// Returns the setup from a job's settings.
MachineSetup SetupOf(const MotionOptions& options);

/// Straight move in machine coordinates: x, y, z and the total filament so far.
struct ProgramMove {
  std::array<double, 4> from = {};
  std::array<double, 4> to = {};
  double speed_mm_s = 0;

  double Filament() const { return to[kE] - from[kE]; }
  bool InPlane() const { return from[kX] != to[kX] || from[kY] != to[kY]; }
  bool InSpace() const { return InPlane() || from[kZ] != to[kZ]; }
  bool Prints() const { return InPlane() && Filament() > 0; }
};

/// Effect of a line on the machine.
struct GcodeAction {
  enum class Kind {
    kNone,
    kMoves,
    kDwell,   ///< G4: a pause
    kRest,    ///< stop: waits for heat, homes, changes tools, ...
    kLimits,  ///< limits may have changed
  };
  Kind kind = Kind::kNone;
  std::span<const ProgramMove> moves = {};  ///< valid until the next line
  double dwell_s = 0;
  std::optional<Arc> arc = {};  ///< arc of G2 and G3
};

/// Runs a program line by line, as its firmware would: G0 to G4, G10 and G11, G20 and G21, G28, G90
/// to G92, M82, M83, M200, M207, M208, M220, M221, tools and limits. All coordinates are 0 until
/// G28 or the first move. Homing moves an axis to 0.
class GcodeMachine {
 public:
  /// `firmware` must outlive this object.
  GcodeMachine(const Firmware& firmware, const MachineSetup& setup)
      : firmware_(firmware),
        limits_(setup.limits),
        retraction_(setup.retraction),
        arc_segment_mm_(setup.arc_segment_mm),
        filament_unit_mm_(FilamentUnitMm(setup.volume_diameter_mm)) {}

  /// Runs one line and returns its effect.
  GcodeAction Read(const GcodeLine& line);

  /// Continues from a position, with a speed and a printing acceleration that were set outside this
  /// program.
  void Resume(const std::array<double, 3>& place_mm, double speed_mm_s, double acceleration_mm_s2);

  const MachineLimits& limits() const { return limits_; }
  const std::array<double, 4>& position() const { return at_; }
  bool relative() const { return relative_; }
  /// Returns true if a feed rate (F) was given.
  bool has_speed() const { return speed_mm_s_ > 0; }

 private:
  static double FilamentUnitMm(double diameter_mm);
  GcodeAction ReadG(const GcodeLine& line);
  GcodeAction ReadM(const GcodeLine& line);
  GcodeAction MoveTo(const GcodeLine& line);
  GcodeAction ArcTo(const GcodeLine& line);
  GcodeAction Retract(bool back);
  void Home(const GcodeLine& line);
  void SetPosition(const GcodeLine& line);
  void ReadSpeed(const GcodeLine& line);
  bool RelativeFilament() const;
  std::array<double, 4> TargetOf(const GcodeLine& line) const;
  void Push(const std::array<double, 4>& to, double speed_mm_s);
  double FilamentFactor() const { return flow_factor_ * filament_unit_mm_; }
  void ScaleFilament(double flow, double unit_mm);

  const Firmware& firmware_;
  MachineLimits limits_;
  RetractionOptions retraction_;
  double arc_segment_mm_;
  std::array<double, 4> at_ = {};
  std::array<double, 4> origin_ = {};  ///< position of the program's zero
  double unit_mm_ = 1;
  bool relative_ = false;
  bool relative_filament_ = false;
  bool retracted_ = false;  ///< retracted by G10
  double speed_mm_s_ = 0;   ///< speed as given, without the factor of M220
  double speed_factor_ = 1;
  double flow_factor_ = 1;
  double filament_unit_mm_ = 1;  ///< mm of filament per unit of E; with M200 the unit is a volume
  std::vector<ProgramMove> moves_;
};

/// Returns true if a line is G10 or G11 for a retraction or restart by the firmware. Returns false
/// for a G10 that sets values of a tool.
bool IsFirmwareRetraction(const GcodeLine& line);

/// Converts a move for planners. REQUIRES: something moves.
KinematicMove ToKinematic(const ProgramMove& move, const Firmware& firmware,
                          const MachineLimits& limits);

}  // namespace slicefarm::motion
