#include "services/motion/algo/program_envelope.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/gcode/gcode_text.h"
#include "common/geometry/measure.h"
#include "common/macro/job_code.h"
#include "common/model/layers/filament_use.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/bambu.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/gcode/extruder_words.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/gcode/object_labels.h"
#include "services/motion/algo/gcode/print_metadata.h"
#include "services/motion/algo/gcode/thumbnails_block.h"
#include "services/motion/algo/layer_travels.h"
#include "services/motion/algo/macro/file_name.h"
#include "services/motion/algo/pass_change.h"
#include "services/motion/algo/print_code.h"
#include "services/motion/algo/program/print_clock.h"
#include "services/motion/algo/text/commands.h"
#include "services/motion/algo/toolpath/footprint.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

int64_t PercentDone(double done_s, double time_s) {
  return time_s > 0 ? std::lround(std::floor(100 * done_s / time_s)) : 0;
}
int64_t MinutesLeft(double done_s, double time_s) {
  return std::lround(std::ceil((time_s - done_s) / 60));
}

/// Times of the whole print, including the machine's silent mode if it has one.
struct ClockedTimes {
  PrintTimes normal;
  std::optional<PrintTimes> silent;

  double TotalS() const { return normal.TotalS(); }
  std::optional<double> SilentS() const {
    return silent ? std::optional(silent->TotalS()) : std::nullopt;
  }
};

/// Writes the progress of the print before each of its layers. A line equal to the previous one is
/// left out.
class ProgressLines {
 public:
  /// `times` and `firmware` must outlive this object.
  ProgressLines(const ClockedTimes& times, const Firmware& firmware)
      : times_(times),
        firmware_(firmware),
        done_s_(times.normal.before_s),
        silent_done_s_(times.silent ? times.silent->before_s : 0) {}

  std::string AtFirst() { return Line(0, 0, 0); }
  std::string BeforeLayer(size_t i) {
    std::string line = Line(static_cast<int64_t>(i) + 1, done_s_, silent_done_s_);
    done_s_ += times_.normal.layer_s[i];
    if (times_.silent) silent_done_s_ += times_.silent->layer_s[i];
    return line;
  }

 private:
  std::string Line(int64_t layer, double done_s, double silent_done_s) {
    GcodeText out;
    const double time_s = times_.TotalS();
    firmware_.WriteProgress(PercentDone(done_s, time_s), MinutesLeft(done_s, time_s), layer, out);
    if (const auto silent_s = times_.SilentS())
      firmware_.WriteSilentProgress(PercentDone(silent_done_s, *silent_s),
                                    MinutesLeft(silent_done_s, *silent_s), out);
    const bool repeats = std::exchange(last_, out.text()) == out.text();
    return repeats ? "" : last_;
  }

  const ClockedTimes& times_;
  const Firmware& firmware_;
  double done_s_;
  double silent_done_s_;
  std::string last_;
};

PrintFacts FactsOf(const ProgramSummary& summary, const MotionOptions& options, double time_s) {
  const FilamentUse use = FilamentUseOf(summary.total, options);
  return {.moves_s = summary.total.TimeS(),
          .total_s = time_s,
          .layers = std::ssize(summary.layers),
          .filament_mm = use.length_mm,
          .volume_mm3 = use.volume_mm3,
          .mass_g = use.mass_g,
          .height_mm = ToMm(static_cast<double>(TopOf(summary))),
          .density_g_cm3 = options.tool().filament_density_g_cm3,
          .diameter_mm = options.tool().filament_diameter_mm,
          .first_layer = Bounds(FirstLayerHull(summary))};
}

/// Returns the comments at the beginning of the file that hosts and previewers read.
std::string Head(const ProgramSummary& summary, const MotionOptions& options, double time_s) {
  GcodeText out;
  const PrintFacts facts = FactsOf(summary, options, time_s);
  const Firmware& firmware = FirmwareOf(options.flavor);
  firmware.WriteHead(facts, out);
  if (options.writing.archive && &firmware != &Bambu()) WriteHeaderBlock("", facts, out);
  if (options.writing.archive) out << ArchiveConfigBlock(options, summary);
  out << MetadataHead(summary) << ThumbnailsBlock(summary.thumbnails);
  return out.Take();
}

/// Writes the label of the only copy before all layers.
void BeginOnlyCopy(const ProgramSummary& summary, const MotionOptions& options, GcodeText& out) {
  if (LabelIsAroundAll(summary.copies.size(), options))
    BeginCopy(summary.copies.front().name, 0, options, out);
}
/// Writes the end of this label after all layers.
void EndOnlyCopy(const ProgramSummary& summary, const MotionOptions& options, GcodeText& out) {
  if (LabelIsAroundAll(summary.copies.size(), options))
    EndCopy(summary.copies.front().name, 0, options, out);
}

/// Returns the text before the layers. Progress and objects are written before the start G-code:
/// printers show the time while they heat, and macros probe the bed below the objects.
std::string Prologue(const ProgramSummary& summary, const MotionOptions& options,
                     const ClockedTimes& times, const StartCode& start) {
  const Firmware& firmware = FirmwareOf(options.flavor);
  const PrintFacts facts = FactsOf(summary, options, times.TotalS());
  GcodeText out;
  out.Lines(firmware.comments().program_begin);
  if (options.progress) out << ProgressLines(times, firmware).AtFirst();
  DefineCopies(summary.copies, options, out);
  out << firmware.comments().feature << "Custom\n";
  WriteMachineLimits(options, out);
  firmware.WriteChecks(options, facts, out);
  WriteStart(options, start, out);
  if (options.tool().pressure_advance > 0)
    firmware.WritePressureAdvance(options.tool().pressure_advance, out);
  WriteLayerLimits(options, out);
  ExtruderWords extruder(options);
  extruder.WriteCanonicalState(out);
  firmware.WriteLayersBegin(out);
  extruder.WriteFirstRetraction(options.tool().retraction, out);
  BeginOnlyCopy(summary, options, out);
  return out.Take();
}

/// Returns a move above the whole print for the end G-code. Objects beside the last layer may be
/// higher than this layer.
std::string RiseAboveAll(const ProgramSummary& summary, const MotionOptions& options) {
  const Coord top_nm = TopOf(summary);
  if (summary.layers.empty() || summary.layers.back().frame.print_z_nm == top_nm) return {};
  return MoveToHeight(ClearHeight(top_nm, options), options);
}

/// Returns the text after the layers.
std::string Ending(const ProgramSummary& summary, const MotionOptions& options,
                   std::string_view end_gcode) {
  GcodeText out;
  EndOnlyCopy(summary, options, out);
  out << RiseAboveAll(summary, options);
  const Firmware& firmware = FirmwareOf(options.flavor);
  if (options.progress) {
    firmware.WriteProgress(100, 0, std::ssize(summary.layers), out);
    if (options.silent_limits) firmware.WriteSilentProgress(100, 0, out);
  }
  out << firmware.comments().feature << "Custom\nM107\n";
  firmware.WriteLayersEnd(out);
  out.Lines(firmware.comments().end_gcode_begin);
  out.Lines(end_gcode);
  out.Lines(firmware.comments().program_end);
  return out.Take();
}

/// Returns the moves from the end of each layer to the next one that go around excluded areas.
std::vector<std::string> PathsBetween(const ProgramSummary& summary, const MotionOptions& options,
                                      std::string_view prologue) {
  std::vector<std::string> moves(summary.layers.size());
  if (options.travel_area.empty()) return moves;
  const LayerTravels ways(options);
  Point from = ways.After(prologue, {});
  for (size_t i = 0; i < moves.size(); ++i) {
    const LayerSummary& layer = summary.layers[i];
    if (layer.empty) continue;
    moves[i] = ways.To(layer, from);
    from = layer.exit;
  }
  return moves;
}

/// All text around the layers, without progress lines.
struct FrameText {
  std::string head;
  std::string prologue;
  std::vector<PassChange> changes;
  std::vector<std::string> ways;    ///< travel to each layer, if it is not straight
  std::vector<std::string> layers;  ///< content of ProgramEnvelope::layer_code
  std::string ending;
  std::string file_name;
};

/// Refuses a print that is too heavy for the machine (machine_max_printed_mass).
absl::Status CheckMass(const ProgramSummary& summary, const MotionOptions& options) {
  const double most_g = options.bed_motor.max_print_mass_g;
  const double mass_g = FilamentUseOf(summary.total, options).mass_g;
  if (most_g <= 0 || mass_g <= most_g) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
      fmt::format(
          "the print weighs {:.1f} g, and machine_max_printed_mass is {:.1f} g: print fewer "
          "copies, or use less infill",
          mass_g, most_g),
      {{"setting", "machine_max_printed_mass"},
       {"limit", fmt::format("{:.1f} g", most_g)},
       {"got", fmt::format("{:.1f} g", mass_g)}});
}

/// Returns the text. `times`: times of the print, for templates.
absl::StatusOr<FrameText> TextOf(const macro::JobCode& code, const ProgramSummary& summary,
                                 const MotionOptions& options, const ClockedTimes& times) {
  if (absl::Status ok = CheckMass(summary, options); !ok.ok()) return ok;
  const double time_s = times.TotalS();
  FrameText text;
  text.changes = PassChanges(summary);
  auto filled = FillIn(code, summary, text.changes, options, time_s, times.SilentS());
  if (!filled.ok()) return filled.status();
  GcodeText top;
  top.Lines(filled->file_start);
  text.head = top.Take() + Head(summary, options, time_s);
  text.file_name = FileName(filled->file_name, options.writing);
  text.prologue = Prologue(summary, options, times, {filled->start, filled->start_filament});
  text.ways = PathsBetween(summary, options, text.prologue);
  for (size_t i = 0; i < text.changes.size(); ++i)
    text.ways[text.changes[i].layer] = GcodeOf(text.changes[i], filled->between[i], options);
  for (std::string& layer : filled->layers) {
    GcodeText lines;
    lines.Lines(layer);
    text.layers.push_back(lines.Take());
  }
  text.ending = Ending(summary, options, filled->end);
  return text;
}

/// Returns the custom G-code that is inserted into layer `i`; empty: the layer contains its code.
std::span<const std::string> CodeOf(const FrameText& text, size_t i) {
  if (text.layers.empty()) return {};
  return std::span(text.layers).subspan(i * kCodesOfALayer, kCodesOfALayer);
}

PrintTimes TimesOf(const ProgramSummary& summary, const FrameText& text,
                   const MotionOptions& options) {
  PrintClock clock(summary, options);
  clock.ReadBefore(text.prologue);
  for (size_t i = 0; i < summary.layers.size(); ++i) {
    if (!text.ways[i].empty()) clock.ReadAt(i, text.ways[i]);
    // The times of the layers contain no code that was not known when they were written.
    for (const std::string& code : CodeOf(text, i)) clock.ReadAt(i, code);
    clock.AddLayer(i);
  }
  clock.ReadAfter(text.ending);
  return clock.Finish();
}

/// Returns G-code without the commands that set limits of axes, because the silent mode has other
/// limits.
std::string WithoutAxisLimits(std::string_view gcode) {
  GcodeText out;
  for (const std::string_view line : Split(gcode, "\n"))
    if (!line.empty() && !Commands(line, {"M201", "M203", "M205"})) out << line << '\n';
  return out.Take();
}

/// Returns the times in silent mode, from the layers' times in this mode. The times by feature are
/// not known.
PrintTimes SilentTimes(ProgramSummary summary, FrameText text, MotionOptions options) {
  options.limits = *options.silent_limits;
  summary.total = {};
  for (LayerSummary& layer : summary.layers) {
    layer.time_s = layer.silent_time_s;
    summary.total.travel_time_s += layer.time_s;
  }
  text.prologue = WithoutAxisLimits(text.prologue);
  return TimesOf(summary, text, options);
}

double TravelMm(const ProgramSummary& summary, const MotionOptions& options) {
  const LayerTravels ways(options);
  double travel_mm = summary.total.travel_mm;
  const LayerSummary* before = nullptr;
  for (const LayerSummary& layer : summary.layers) {
    if (layer.empty) continue;
    if (before != nullptr) {
      Polyline travel = ways.Corners(before->exit, layer.entry);
      travel.insert(travel.begin(), before->exit);
      travel.push_back(layer.entry);
      travel_mm += ToMm(Length(travel));
    }
    before = &layer;
  }
  return travel_mm;
}

}  // namespace

absl::StatusOr<ProgramEnvelope> FrameProgram(const ProgramSummary& summary,
                                             const MotionOptions& options) {
  // Templates may use the time of the whole print, but the moves in their own text are part of it.
  // So there are two rounds: in the first one, templates get the time of the layers only.
  const auto code = macro::ParseJobCode(options);
  if (!code.ok()) return code.status();
  ClockedTimes times;
  times.normal.travel_s = summary.total.TimeS();
  auto text = TextOf(*code, summary, options, times);
  if (!text.ok()) return text.status();
  times.normal = TimesOf(summary, *text, options);
  if (options.silent_limits) times.silent = SilentTimes(summary, *text, options);
  text = TextOf(*code, summary, options, times);
  if (!text.ok()) return text.status();

  ProgramEnvelope frame;
  frame.travel_mm = TravelMm(summary, options);
  frame.layer_prefixes.resize(summary.layers.size());
  if (options.progress) {
    ProgressLines progress(times, FirmwareOf(options.flavor));
    for (size_t i = 0; i < summary.layers.size(); ++i)
      frame.layer_prefixes[i] = progress.BeforeLayer(i);
  }
  for (size_t i = 0; i < text->ways.size(); ++i) frame.layer_prefixes[i] += text->ways[i];
  frame.layer_code = std::move(text->layers);
  frame.prologue = std::move(text->prologue);
  frame.epilogue = std::move(text->ending);
  frame.head = std::move(text->head);
  frame.tail = MetadataTail(options, summary, times.normal, times.silent);
  frame.times = std::move(times.normal);
  frame.file_name = std::move(text->file_name);
  return frame;
}

}  // namespace slicefarm::motion
