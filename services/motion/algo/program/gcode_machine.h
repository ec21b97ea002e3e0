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

/// Printer settings that G-code refers to but does not contain.
struct MachineSetup {
  MachineLimits limits;
  /// retraction by which G10 and G11 move the filament, until M207 changes it
  RetractionOptions retraction;
  HeatingRates heating;
  /// Diameter of the filament if E is a volume in mm3; 0 if E is a length in mm. M200 changes it.
  double volume_diameter_mm = 0;
  double arc_segment_mm = 0;  ///< length of the chords of arcs; 0: the firmware's own
};

/// Returns the setup from a job's settings.
MachineSetup SetupOf(const MotionOptions& options);

/// Straight move: its two ends in machine coordinates x, y, z and the total filament so far, in mm.
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
    kRest,    ///< the machine stops: waits for heat, homes, changes tools, ...
    kLimits,  ///< limits may have changed
  };
  Kind kind = Kind::kNone;
  /// moves of the line; the memory is valid until the next call of Read
  std::span<const ProgramMove> moves = {};
  double dwell_s = 0;
  std::optional<Arc> arc = {};  ///< arc of G2 and G3
};

/// Machine that runs a program line by line, as its firmware would. Commands: G0 to G4, G10 and
/// G11, G20 and G21, G28, G90 to G92, M82, M83, M200, M207, M208, M220, M221, tools and limits. All
/// coordinates are 0 until G28 or the first move. Homing moves an axis to 0.
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

  /// Sets the position, the speed and the printing acceleration of the machine. Call this after
  /// moves that are not in the text that Read gets.
  void Resume(const std::array<double, 3>& position_mm, double speed_mm_s,
              double acceleration_mm_s2);

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
  std::array<double, 4> origin_ = {};  ///< machine coordinates of the program's zero, as set by G92
  double unit_mm_ = 1;
  bool relative_ = false;
  bool relative_filament_ = false;
  bool retracted_ = false;  ///< true after a retraction by G10
  double speed_mm_s_ = 0;   ///< last feed rate (F) in mm/s, before the factor of M220
  double speed_factor_ = 1;
  double flow_factor_ = 1;
  /// mm of filament per unit of E; with M200 the unit of E is 1 mm^3
  double filament_unit_mm_ = 1;
  std::vector<ProgramMove> moves_;
};

/// Returns true if the line is a G10 or G11 that retracts or restarts the filament. Returns false
/// for a G10 that sets values of a tool.
bool IsFirmwareRetraction(const GcodeLine& line);

/// Converts a move into the form for planners. REQUIRES: the move has a length, in space or in
/// filament.
KinematicMove ToKinematic(const ProgramMove& move, const Firmware& firmware,
                          const MachineLimits& limits);

}  // namespace slicefarm::motion
