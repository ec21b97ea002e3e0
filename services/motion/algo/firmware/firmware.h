#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "common/gcode/gcode_text.h"
#include "common/kinematics/planner.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/text/gcode_line.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// What decides whether the filament's numbers are absolute.
enum class ExtruderMode {
  kApart,       ///< M82 and M83 alone
  kWithAxes,    ///< G90 and G91 set it as well
  kEitherWise,  ///< relative after G91 as well as after M83
};

/// How the comments begin that tell previewers and hosts what is printed.
struct CommentWords {
  std::string_view layer_change = ";LAYER_CHANGE";
  std::string_view z = ";Z:";
  std::string_view height = ";HEIGHT:";
  std::string_view feature = ";TYPE:";
  std::string_view width = ";WIDTH:";
  std::string_view wipe_start = ";WIPE_START";
  std::string_view wipe_end = ";WIPE_END";
  // Lines around what the printer runs, and around the settings' own G-code; empty: none.
  std::string_view program_begin = {};
  std::string_view program_end = {};
  std::string_view start_gcode_end = {};
  std::string_view end_gcode_begin = {};
};

/// What the head of a file may tell of a whole print.
struct PrintFacts {
  double moves_s = 0;  ///< without the settings' own G-code
  double total_s = 0;
  int64_t layers = 0;
  double filament_mm = 0;
  double volume_mm3 = 0;
  double mass_g = 0;
  double height_mm = 0;
  double density_g_cm3 = 0;
  double diameter_mm = 0;
  Box first_layer;  ///< what it covers
};

/// The firmware of a printer: what it makes of moves, and the dialect that it reads. One file a
/// firmware: marlin.cc, klipper.cc, reprap.cc, ... Has no state.
class Firmware {
 public:
  virtual ~Firmware() = default;

  /// The value of gcode_flavor.
  virtual std::string_view name() const = 0;

  // Motion.

  virtual std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const = 0;
  /// What the machine is set to for such a move (M204, SET_VELOCITY_LIMIT), before the limits of
  /// its axes.
  virtual double AccelerationFor(const KinematicMove& move, const MachineLimits& limits) const = 0;
  /// Whether it comes to rest before and after moves of filament alone.
  virtual bool StopsForFilament() const { return false; }
  /// Length of the chords that stand for an arc.
  virtual double ArcSegmentMm(double radius_mm, double speed_mm_s) const = 0;

  // What it reads.

  virtual ExtruderMode extruder_mode() const = 0;
  /// Whether it knows the command.
  virtual bool Knows(const GcodeLine& line) const = 0;
  /// Whether a word may have several numbers (`E1:0`), or a text in quotes.
  virtual bool HasLists() const { return false; }
  /// Whether a command of any name may be one of the user's macros.
  virtual bool has_macros() const { return false; }
  /// Takes over what a command says of limits; nothing of other commands.
  virtual void ApplyLimits(const GcodeLine& line, MachineLimits& limits) const = 0;
  /// Whether a bead of such a section is refused. `nozzle_mm`: diameter.
  virtual bool RefusesSection(double section_mm2, double nozzle_mm) const;
  /// Moves of filament alone that are longer are refused; 0: none.
  virtual double LongestExtrusionMm() const { return 0; }
  /// Whether arcs may be given by radius, and between relative coordinates.
  virtual bool ArcsByRadius() const { return true; }
  virtual bool RelativeArcs() const { return true; }

  // What is written for it.

  /// Limits of 0 are left as they are.
  virtual void WriteLimits(const MachineLimits& limits, GcodeText& out) const = 0;
  /// Whether travels have an acceleration of their own, told once beside that of printing.
  virtual bool HasTravelAcceleration() const = 0;
  /// Whether moves of filament alone have one of their own.
  virtual bool HasRetractAcceleration() const { return true; }
  /// Tells the acceleration of printing, of travels, or both; 0: not told. REQUIRES: not both are
  /// 0, and `travel_mm_s2` is 0 unless HasTravelAcceleration.
  virtual void WriteAcceleration(double print_mm_s2, double travel_mm_s2, GcodeText& out) const = 0;

  /// Pressure advance (linear advance), in the firmware's own unit.
  virtual void WritePressureAdvance(double value, GcodeText& out) const;
  /// `left_min`: minutes left; `layer`: from 1.
  virtual void WriteProgress(int64_t percent, int64_t left_min, int64_t layer,
                             GcodeText& out) const;
  /// The same for the machine's silent mode.
  virtual void WriteSilentProgress(int64_t percent, int64_t left_min, GcodeText& out) const;
  /// What the printer is asked before anything moves: whether it is the one that the file is for.
  virtual void WriteChecks(const MotionOptions& options, const PrintFacts& facts,
                           GcodeText& out) const;
  /// What has to stand at the head of a file, as comments.
  virtual void WriteHead(const PrintFacts& facts, GcodeText& out) const;
  virtual const CommentWords& comments() const;
  /// Writes what the printer is told of the print before the first layer, at the second one, and
  /// after the last one.
  virtual void WriteLayersBegin(GcodeText& /*out*/) const {}
  virtual void WriteSecondLayer(GcodeText& /*out*/) const {}
  virtual void WriteLayersEnd(GcodeText& /*out*/) const {}
  /// What it calls a feature.
  virtual std::string_view WordsOf(Feature feature) const { return FeatureType(feature); }

  /// Of a mixing extruder: what part of the flow each material has. By M163 for
  /// each, and M164 to store them as tool 0. REQUIRES: it mixes (CheckMixing of common/config).
  virtual void WriteMix(std::span<const double> shares, GcodeText& out) const;

  /// Of a copy, for gcode_label_objects = firmware. `name`: one line; `index`: of the copy.
  virtual std::string LabelOf(std::string_view name, size_t index) const = 0;
  virtual void DefineCopies(std::span<const CopySummary> copies,
                            std::span<const std::string> labels, GcodeText& out) const = 0;
  virtual void BeginCopy(std::string_view label, size_t index, GcodeText& out) const = 0;
  virtual void EndCopy(std::string_view label, size_t index, GcodeText& out) const = 0;
  /// Returns true if a print of one copy has its label once, around all layers.
  virtual bool LabelsLast() const { return false; }
};

/// That of the settings. Lives for ever.
const Firmware& FirmwareOf(GcodeFlavor flavor);

/// By name: klipper; marlin or marlin2, Marlin 2 both; rrf or reprapfirmware; prusabuddy; bambu;
/// grbl; jerk: none but slicefarm's own planner (jerk.h). Null: no such.
const Firmware* FindFirmware(std::string_view name);

}  // namespace slicefarm::motion
