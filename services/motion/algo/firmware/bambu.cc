#include "services/motion/algo/firmware/bambu.h"

#include <array>

#include "absl/strings/escaping.h"
#include "common/base/duration_text.h"
#include "services/motion/algo/firmware/limit_command.h"
#include "services/motion/algo/firmware/marlin.h"

namespace slicefarm::motion {
namespace {

constexpr CommentWords kComments = {.layer_change = "; CHANGE_LAYER",
                                    .z = "; Z_HEIGHT: ",
                                    .height = "; LAYER_HEIGHT: ",
                                    .feature = "; FEATURE: ",
                                    .width = "; LINE_WIDTH: ",
                                    .wipe_start = "; WIPE_START",
                                    .wipe_end = "; WIPE_END",
                                    .program_begin = "; EXECUTABLE_BLOCK_START",
                                    .program_end = "; EXECUTABLE_BLOCK_END",
                                    .start_gcode_end = "; MACHINE_START_GCODE_END",
                                    .end_gcode_begin = "; MACHINE_END_GCODE_START"};

constexpr std::array<std::string_view, kFeatureCount> kFeatures = {"Outer wall",
                                                                   "Inner wall",
                                                                   "Overhang wall",
                                                                   "Gap infill",
                                                                   "Sparse infill",
                                                                   "Internal solid infill",
                                                                   "Top surface",
                                                                   "Bridge",
                                                                   "Skirt",
                                                                   "Support",
                                                                   "Support interface",
                                                                   "Ironing",
                                                                   "Internal solid infill",
                                                                   "Internal Bridge"};

/// Largest number of objects that the printer can skip. Each object is a bit of a mask. The mask's
/// bytes are written as base64, the lowest byte first.
constexpr size_t kMostLabels = 64;

std::string MaskOf(size_t index) {
  std::string bytes(kMostLabels / 8, '\0');
  if (index < kMostLabels) bytes[index / 8] = static_cast<char>(1 << index % 8);
  std::string code;
  absl::Base64Escape(bytes, &code);
  return code;
}

/// Sources: G-code of Bambu Studio 2.4 and its documentation of M624, M625 and M73.
class BambuFirmware : public MarlinFirmware {
 public:
  std::string_view name() const override { return "bambu"; }

  bool Knows(const GcodeLine& line) const override {
    const bool own = line.letter == 'M' && ((line.number >= 620 && line.number <= 634) ||
                                            (line.number >= 960 && line.number <= 1010));
    const bool moves_bed = line.letter == 'G' && (line.number == 380 || line.number == 392);
    return own || moves_bed || MarlinFirmware::Knows(line);
  }

  bool HasTravelAcceleration() const override { return false; }
  void WriteAcceleration(double print_mm_s2, double /*travel_mm_s2*/,
                         GcodeText& out) const override {
    WriteM204(print_mm_s2, out);
  }
  /// Writes all axes, as Bambu Studio does.
  void WriteJerk(std::span<const double, 4> jerk_mm_s, GcodeText& out) const override {
    LimitCommand("M205", out).SetAxes(jerk_mm_s);
  }
  bool HasJunctionDeviation() const override { return false; }
  double AccelerationFor(const KinematicMove& move, const MachineLimits& limits) const override {
    KinematicMove printing = move;
    if (!move.ExtruderOnly()) printing.ratio[kE] = 1;
    return MarlinFirmware::AccelerationFor(printing, limits);
  }

  /// Turns on the printer's camera check for failed prints ("spaghetti") and, later, the recovery
  /// after a power loss. The layer number (M73 L) is in the layer_gcode of all Bambu profiles.
  void WriteLayersBegin(GcodeText& out) const override {
    out << "M981 S1 P20000 ; open spaghetti detector\n";
  }
  void WriteSecondLayer(GcodeText& out) const override {
    out << "; open powerlost recovery\nM1003 S1\n";
  }
  void WriteLayersEnd(GcodeText& out) const override {
    out << "; close powerlost recovery\nM1003 S0\nM981 S0 P20000 ; close spaghetti detector\n";
  }

  void WriteHead(const PrintFacts& facts, GcodeText& out) const override {
    WriteHeaderBlock("; BambuStudio 02.00.00.00\n", facts, out);
  }

  const CommentWords& comments() const override { return kComments; }
  std::string_view WordsOf(Feature feature) const override {
    return kFeatures[static_cast<size_t>(feature)];
  }

  void DefineCopies(std::span<const CopySummary> /*copies*/, std::span<const std::string> labels,
                    GcodeText& out) const override {
    out << "; model label id: ";
    for (size_t i = 0; i < labels.size(); ++i) out << (i > 0 ? "," : "") << labels[i];
    out << '\n';
  }
  /// Returns the id by which the printer's screen and its network interface name the copy.
  std::string LabelOf(std::string_view /*name*/, size_t index) const override {
    return std::to_string(index);
  }
  bool LabelsLast() const override { return false; }
  /// Copies beyond the size of the mask cannot be skipped.
  void BeginCopy(std::string_view label, size_t index, GcodeText& out) const override {
    if (index >= kMostLabels) return;
    out << "; start printing object, unique label id: " << label << "\nM624 " << MaskOf(index)
        << '\n';
  }
  void EndCopy(std::string_view label, size_t index, GcodeText& out) const override {
    if (index >= kMostLabels) return;
    out << "; stop printing object, unique label id: " << label << "\nM625\n";
  }

 protected:
  /// Writes the same acceleration for printing and travel, as legacy Marlin does.
  void WriteAccelerationLimits(const MachineLimits& limits, GcodeText& out) const override {
    LimitCommand("M204", out)
        .Set("P", limits.max_acceleration_extruding_mm_s2)
        .Set("R", limits.max_acceleration_retracting_mm_s2)
        .Set("T", limits.max_acceleration_extruding_mm_s2);
  }
};

}  // namespace

void WriteHeaderBlock(std::string_view program, const PrintFacts& facts, GcodeText& out) {
  out << "; HEADER_BLOCK_START\n"
      << program << "; model printing time: " << DurationText(facts.moves_s)
      << "; total estimated time: " << DurationText(facts.total_s) << "\n; total layer number: ";
  out.Integer(facts.layers) << "\n; total filament length [mm] : ";
  out.Real(facts.filament_mm, 2) << "\n; total filament volume [cm^3] : ";
  // The value is in mm3 in spite of the key's unit, as in Bambu Studio.
  out.Real(facts.volume_mm3, 2) << "\n; total filament weight [g] : ";
  out.Real(facts.mass_g, 2) << "\n; filament_density: ";
  out.Real(facts.density_g_cm3, 2) << "\n; filament_diameter: ";
  out.Real(facts.diameter_mm, 2) << "\n; max_z_height: ";
  out.Real(facts.height_mm, 2) << "\n; filament: 1\n; HEADER_BLOCK_END\n\n";
}

const Firmware& Bambu() {
  static const BambuFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
