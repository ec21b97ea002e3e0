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

/// Relation of the mode of the filament's coordinate (E), absolute or relative, to G-code commands.
enum class ExtruderMode {
  kApart,       ///< only M82 and M83 set the mode of E
  kWithAxes,    ///< G90 and G91 set the mode of E as well
  kEitherWise,  ///< E is relative if the last of G90/G91 was G91, or the last of M82/M83 was M83
};

/// Beginnings of the comment lines that previewers and hosts read.
struct CommentWords {
  std::string_view layer_change = ";LAYER_CHANGE";
  std::string_view z = ";Z:";
  std::string_view height = ";HEIGHT:";
  std::string_view feature = ";TYPE:";
  std::string_view width = ";WIDTH:";
  std::string_view wipe_start = ";WIPE_START";
  std::string_view wipe_end = ";WIPE_END";
  // Comment lines around the executable part of a program, and around the start and end G-code;
  // empty: the firmware has no such line.
  std::string_view program_begin = {};
  std::string_view program_end = {};
  std::string_view start_gcode_end = {};
  std::string_view end_gcode_begin = {};
};

/// Facts about a whole print for the head of a file.
struct PrintFacts {
  double moves_s = 0;  ///< time of the layers' moves, without the settings' own G-code
  double total_s = 0;
  int64_t layers = 0;
  double filament_mm = 0;
  double volume_mm3 = 0;
  double mass_g = 0;
  double height_mm = 0;
  double density_g_cm3 = 0;
  double diameter_mm = 0;
  Box first_layer;  ///< bounding box of the first layer's beads
};

/// Firmware of a printer: the rules by which it plans moves, and its G-code dialect. Each firmware
/// is one file: marlin.cc, klipper.cc, reprap.cc, ... Objects have no state.
class Firmware {
 public:
  virtual ~Firmware() = default;

  /// Returns the firmware's name as a value of gcode_flavor.
  virtual std::string_view name() const = 0;

  // Motion.

  /// Returns a new look-ahead planner of this firmware.
  virtual std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const = 0;
  /// Returns the acceleration in mm/s^2 that M204 or SET_VELOCITY_LIMIT set for moves of the kind
  /// of `move`, before the axes' limits are applied.
  virtual double AccelerationFor(const KinematicMove& move, const MachineLimits& limits) const = 0;
  /// Returns true if the machine stops before and after a move in which only the filament moves.
  virtual bool StopsForFilament() const { return false; }
  /// Returns the length of the chords that the firmware divides an arc into.
  virtual double ArcSegmentMm(double radius_mm, double speed_mm_s) const = 0;

  // Reading of G-code.

  /// Returns the commands that switch the filament between absolute and relative.
  virtual ExtruderMode extruder_mode() const = 0;
  /// Returns true if the firmware supports the command of the line.
  virtual bool Knows(const GcodeLine& line) const = 0;
  /// Returns true if the number of a word may be a list (`E1:0`) or a text in quotes.
  virtual bool HasLists() const { return false; }
  /// Returns true if users can define commands (macros). The program check then accepts unknown
  /// commands in custom G-code.
  virtual bool has_macros() const { return false; }
  /// Applies the limits in a command to `limits`. Other commands are ignored.
  virtual void ApplyLimits(const GcodeLine& line, MachineLimits& limits) const = 0;
  /// Returns true if the firmware refuses to print a bead with this cross-section. `nozzle_mm`:
  /// diameter of the nozzle.
  virtual bool RefusesSection(double section_mm2, double nozzle_mm) const;
  /// Returns the longest accepted move, in mm of filament, in which only the filament moves; 0: no
  /// limit.
  virtual double LongestExtrusionMm() const { return 0; }
  /// Returns true if the firmware accepts arcs given by their radius.
  virtual bool ArcsByRadius() const { return true; }
  /// Returns true if the firmware accepts arcs while coordinates are relative.
  virtual bool RelativeArcs() const { return true; }

  // Writing of G-code.

  /// Writes the machine limits. Limits of 0 are not written.
  virtual void WriteLimits(const MachineLimits& limits, GcodeText& out) const = 0;
  /// Returns true if travels have an acceleration of their own, which is set separately from the
  /// printing acceleration.
  virtual bool HasTravelAcceleration() const = 0;
  /// Returns true if moves in which only the filament moves have an acceleration of their own.
  virtual bool HasRetractAcceleration() const { return true; }
  /// Writes the acceleration of printing, of travels, or of both. A value of 0 is not written.
  /// REQUIRES: at least one value is not 0, and `travel_mm_s2` is 0 if HasTravelAcceleration is
  /// false.
  virtual void WriteAcceleration(double print_mm_s2, double travel_mm_s2, GcodeText& out) const = 0;

  /// Writes the acceleration of printing together with that of moves too short to cruise (Klipper).
  virtual void WriteAccelToDecel(double /*print_mm_s2*/, double /*to_decel_mm_s2*/,
                                 GcodeText& /*out*/) const {}
  /// Writes Klipper's minimum_cruise_ratio.
  virtual void WriteCruiseRatio(double /*ratio*/, GcodeText& /*out*/) const {}
  /// Writes the jerk in x and y, in mm/s. `jerk_mm_s`: of x, y, z and e.
  virtual void WriteJerk(std::span<const double, 4> jerk_mm_s, GcodeText& out) const = 0;
  /// Returns true if the firmware has a junction deviation (Marlin 2).
  virtual bool HasJunctionDeviation() const { return false; }
  virtual void WriteJunctionDeviation(double /*deviation_mm*/, GcodeText& /*out*/) const {}

  /// Writes pressure advance (linear advance), in the firmware's own unit.
  virtual void WritePressureAdvance(double value, GcodeText& out) const;
  /// Writes the progress. `percent`: 0 to 100; `left_min`: minutes left; `layer`: number of the
  /// layer, from 1.
  virtual void WriteProgress(int64_t percent, int64_t left_min, int64_t layer,
                             GcodeText& out) const;
  /// Writes the progress of the machine's silent mode.
  virtual void WriteSilentProgress(int64_t percent, int64_t left_min, GcodeText& out) const;
  /// Writes commands that check before the first move that the file is for this printer.
  virtual void WriteChecks(const MotionOptions& options, const PrintFacts& facts,
                           GcodeText& out) const;
  /// Writes the comments that the firmware needs at the head of a file.
  virtual void WriteHead(const PrintFacts& facts, GcodeText& out) const;
  /// Returns the firmware's comments.
  virtual const CommentWords& comments() const;
  /// Writes the firmware's G-code before the first layer.
  virtual void WriteLayersBegin(GcodeText& /*out*/) const {}
  /// Writes the firmware's G-code at the second layer.
  virtual void WriteSecondLayer(GcodeText& /*out*/) const {}
  /// Writes the firmware's G-code after the last layer.
  virtual void WriteLayersEnd(GcodeText& /*out*/) const {}
  /// Returns the firmware's name of a feature, as it is written after CommentWords::feature.
  virtual std::string_view WordsOf(Feature feature) const { return FeatureType(feature); }

  /// Writes the share of each material for a mixing extruder: one M163 per material, then M164 to
  /// store the shares as tool 0. REQUIRES: the extruder mixes (CheckMixing of common/config).
  virtual void WriteMix(std::span<const double> shares, GcodeText& out) const;

  /// Returns the label of a copy for gcode_label_objects = firmware. `name`: one line; `index`:
  /// index of the copy.
  virtual std::string LabelOf(std::string_view name, size_t index) const = 0;
  /// Writes the definitions of all copies at the head of the file. `labels`: LabelOf of each copy.
  virtual void DefineCopies(std::span<const CopySummary> copies,
                            std::span<const std::string> labels, GcodeText& out) const = 0;
  /// Writes the lines at the start of a copy. `label`: LabelOf of the copy; `index`: index of the
  /// copy.
  virtual void BeginCopy(std::string_view label, size_t index, GcodeText& out) const = 0;
  /// Writes the lines at the end of a copy.
  virtual void EndCopy(std::string_view label, size_t index, GcodeText& out) const = 0;
  /// Returns true if, in a job with one copy, its label is written once around all layers instead
  /// of in each layer.
  virtual bool LabelsLast() const { return false; }
};

/// Returns the firmware of a flavor. The object lives until the program ends.
const Firmware& FirmwareOf(GcodeFlavor flavor);

/// Returns the firmware of this name, or null if there is none. Names: klipper; marlin or marlin2
/// (both are Marlin 2); rrf or reprapfirmware; prusabuddy; bambu; grbl; jerk (slicefarm's own
/// planner, jerk.h).
const Firmware* FindFirmware(std::string_view name);

}  // namespace slicefarm::motion
