#include "services/motion/algo/program/program_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "absl/strings/str_format.h"
#include "common/base/portable_math.h"
#include "common/base/text.h"
#include "services/motion/algo/program/filament_watch.h"
#include "services/motion/algo/program/machine_space.h"
#include "services/motion/algo/program/program_labels.h"

namespace slicefarm::motion {
namespace {

/// Resolution of coordinates, 0.001 mm.
constexpr double kPlaceMm = 0.001;
/// Largest section of a bead, as a multiple of the squared nozzle diameter.
constexpr double kMostSections = 4;
/// Tolerance of the radii at an arc's ends. They depend on four numbers with a resolution of 0.001
/// mm.
constexpr double kRadiusMm = 0.005;
/// Tolerances of sums of filament: one for the two decimals of the comment, one for the rounding of
/// each move to 1e-5 mm.
constexpr double kSumMm = 0.006;
constexpr double kSumOfRoundingMm = 3e-5;
constexpr std::string_view kMoveWords = "XYZEFSHRPABCUVWIJK";
constexpr std::string_view kValuedWords = "XYZEFIJKR";

class Checker {
 public:
  Checker(const Firmware& firmware, const CheckSetup& setup)
      : firmware_(firmware),
        setup_(setup),
        machine_(firmware, setup.machine),
        space_(setup.bed, setup.max_height_mm, std::min(0.0, setup.z_offset_mm)),
        filament_(setup.machine.retraction.restart_extra_mm, firmware.LongestExtrusionMm()),
        filament_mm2_(std::numbers::pi / 4 * setup.filament_mm * setup.filament_mm) {}

  void Read(std::string_view text) {
    ++report_.lines;
    if (text.ends_with('\r')) text.remove_suffix(1);
    const GcodeLine line = ParseGcodeLine(text);
    if (!line.comment.empty()) ReadComment(line.comment);
    if (line.command.empty()) return;
    const bool is_move = line.letter == 'G' && line.number >= 0 && line.number <= 3;
    // Vendors' own commands may repeat a word, for example M970.3 in Bambu's start G-code.
    const bool vendors = labels_.Custom() && !is_move && line.fault == kWordTwice;
    if (!line.fault.empty() && !vendors) return Find(absl::StrFormat("%s: %s", text, line.fault));
    CheckCommand(line);
    if (is_move) CheckWords(line);
    if (line.Is('G', 2) || line.Is('G', 3)) CheckArcForm(line);
    NoteTemperature(line);
    const GcodeAction action = machine_.Read(line);
    if (action.arc) CheckArc(*action.arc);
    for (const ProgramMove& move : action.moves) CheckMove(move);
    if (line.letter == 'T') filament_.ChangeTool(labels_.Custom());
    if (IsFirmwareRetraction(line)) CheckFirmwareRetraction(line);
  }

  ProgramReport Finish() {
    report_.filament_mm = filament_.PrintedMm();
    const double tolerance =
        kSumMm + kSumOfRoundingMm * std::sqrt(static_cast<double>(report_.moves));
    if (written_mm_ && std::abs(*written_mm_ - report_.filament_mm) > tolerance) {
      Find(absl::StrFormat("filament used [mm] = %.5f, but the program extrudes %.5f", *written_mm_,
                           report_.filament_mm),
           written_line_);
    }
    return std::move(report_);
  }

 private:
  void Find(std::string text) { Find(std::move(text), report_.lines); }
  void Find(std::string text, int64_t line) {
    ++report_.found;
    if (report_.findings.size() < kMostFindings)
      report_.findings.push_back({line, std::move(text)});
  }

  void ReadComment(std::string_view comment) {
    labels_.Read(comment);
    const auto written = QuotedValue(comment, "filament used [mm]");
    if (!written) return;
    double sum = 0;
    for (const std::string_view part : Split(*written, ",;")) {
      const auto number = ToNumber(Trim(part));
      if (!number) return;
      sum += *number;
    }
    written_mm_ = sum;
    written_line_ = report_.lines;
  }

  void CheckCommand(const GcodeLine& line) {
    if (line.has_lists && !firmware_.HasLists())
      Find(absl::StrFormat("%s: %s does not read lists and quoted texts", line.command,
                           firmware_.name()));
    if (firmware_.Knows(line)) return;
    if (firmware_.has_macros() && labels_.Custom() && line.letter == 0) {
      heated_ = true;  // a macro may heat the nozzle
      return;
    }
    Find(absl::StrFormat("%s: unknown command for %s", line.command, firmware_.name()));
  }

  void CheckWords(const GcodeLine& line) {
    for (char word = 'A'; word <= 'Z'; ++word) {
      if (!line.Has(word)) continue;
      if (kMoveWords.find(word) == kMoveWords.npos)
        Find(absl::StrFormat("%s has no word %c", line.command, word));
      if (!line[word] && kValuedWords.find(word) != kValuedWords.npos)
        Find(absl::StrFormat("%s: %c has no number", line.command, word));
    }
    if (const auto f = line['F']; f && *f <= 0)
      Find(absl::StrFormat("F%g: a speed must be above 0", *f));
  }

  void CheckArcForm(const GcodeLine& line) {
    if (line['R']) {
      if (!firmware_.ArcsByRadius())
        Find(absl::StrFormat("%s does not support arcs by radius", firmware_.name()));
    } else if (line['I'].value_or(0) == 0 && line['J'].value_or(0) == 0) {
      Find("an arc without its centre");
    }
    if (machine_.relative() && !firmware_.RelativeArcs())
      Find(absl::StrFormat("%s does not support arcs between relative coordinates",
                           firmware_.name()));
  }

  void CheckArc(const Arc& arc) {
    const double start = arc.StartRadius(), end = arc.EndRadius();
    if (std::abs(start - end) > kRadiusMm)
      Find(absl::StrFormat("an arc begins %.4f mm from its centre and ends %.4f mm from it", start,
                           end));
  }

  void CheckMove(const ProgramMove& move) {
    ++report_.moves;
    const bool custom = labels_.Custom();
    // The slicer may lift the nozzle even if custom G-code has left it outside, for example beside
    // the bed.
    const bool stays = move.to[kX] == move.from[kX] && move.to[kY] == move.from[kY];
    const double outside = stays ? space_.OutsideHeight(move.to[kZ])
                                 : space_.Outside(move.to[kX], move.to[kY], move.to[kZ]);
    if (move.InSpace() && outside > kPlaceMm + (custom ? kCustomMarginMm : 0)) {
      Find(absl::StrFormat("moves to %.3f %.3f %.3f, %.3f mm outside the machine", move.to[kX],
                           move.to[kY], move.to[kZ], outside));
    }
    const double mm = move.Filament();
    if (mm > 0 && !heated_) {
      heated_ = true;
      Find("pushes filament before a nozzle temperature is set");
    }
    if (move.Prints()) CheckSection(move, custom);
    if (auto wrong = filament_.Add(move, custom)) Find(*std::move(wrong));
  }

  void CheckSection(const ProgramMove& move, bool custom) {
    const double x = move.to[kX] - move.from[kX], y = move.to[kY] - move.from[kY];
    const double z = move.to[kZ] - move.from[kZ];
    const double section = move.Filament() * filament_mm2_ / std::sqrt(x * x + y * y + z * z);
    const double most = kMostSections * setup_.nozzle_mm * setup_.nozzle_mm;
    // Firmwares accept any section if the amount of plastic is very small.
    if (section <= most || move.Filament() * filament_mm2_ <= setup_.nozzle_mm * most) return;
    if (custom && !firmware_.RefusesSection(section, setup_.nozzle_mm)) return;
    Find(absl::StrFormat("a line with a section of %.3f mm2, at most %.3f", section, most));
  }

  void CheckFirmwareRetraction(const GcodeLine& line) {
    const bool back = line.number == 11;
    if (labels_.layer() >= 0 && !labels_.Custom() && back != firmware_retracted_)
      Find(back ? "G11 without a G10 before" : "G10 twice without a G11 between");
    firmware_retracted_ = !back;
  }

  void NoteTemperature(const GcodeLine& line) {
    const bool nozzle = line.Is('M', 104) || line.Is('M', 109) || line.Is('M', 568) ||
                        (line.Is('G', 10) && line.Has('P'));
    if (nozzle && (line['S'].value_or(0) > 0 || line['R'].value_or(0) > 0)) heated_ = true;
    if (line.command == "SET_HEATER_TEMPERATURE") heated_ = true;
  }

  const Firmware& firmware_;
  const CheckSetup& setup_;
  GcodeMachine machine_;
  MachineSpace space_;
  FilamentWatch filament_;
  double filament_mm2_;
  ProgramLabels labels_;
  bool heated_ = false;
  bool firmware_retracted_ = false;
  std::optional<double> written_mm_;
  int64_t written_line_ = 0;
  ProgramReport report_;
};

}  // namespace

ProgramReport CheckProgram(std::string_view gcode, const Firmware& firmware,
                           const CheckSetup& setup) {
  Checker checker(firmware, setup);
  while (!gcode.empty()) {
    const size_t end = std::min(gcode.find('\n'), gcode.size());
    checker.Read(gcode.substr(0, end));
    gcode.remove_prefix(std::min(end + 1, gcode.size()));
  }
  return checker.Finish();
}

}  // namespace slicefarm::motion
