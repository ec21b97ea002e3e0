#include "services/motion/algo/program_envelope.h"

#include <cmath>
#include <string>
#include <utility>

#include "common/gcode/gcode_text.h"
#include "common/geometry/measure.h"
#include "common/macro/job_code.h"
#include "common/model/filament_use.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/gcode/extruder_words.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/gcode/object_labels.h"
#include "services/motion/algo/gcode/print_metadata.h"
#include "services/motion/algo/gcode/thumbnails_block.h"
#include "services/motion/algo/macro/file_name.h"
#include "services/motion/algo/macro/print_code.h"
#include "services/motion/algo/layer_ways.h"
#include "services/motion/algo/pass_change.h"
#include "services/motion/algo/program/print_clock.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// Percent done, minutes left.
std::string ProgressLine(double done_s, double time_s, size_t layer, const Firmware& firmware) {
  GcodeText out;
  const double share = time_s > 0 ? done_s / time_s : 0;
  firmware.WriteProgress(std::lround(std::floor(100 * share)),
                         std::lround(std::ceil((time_s - done_s) / 60)),
                         static_cast<int64_t>(layer) + 1, out);
  return out.Take();
}

PrintFacts FactsOf(const ProgramSummary& summary, const MotionOptions& options, double time_s) {
  const FilamentUse use = FilamentUseOf(summary.total, options);
  return {.moves_s = summary.total.TimeS(),
          .total_s = time_s,
          .layers = std::ssize(summary.layers),
          .filament_mm = use.length_mm,
          .volume_mm3 = use.volume_mm3,
          .mass_g = use.mass_g,
          .height_mm = ToMm(static_cast<double>(TopOf(summary))),
          .density_g_cm3 = options.filament_density_g_cm3,
          .diameter_mm = options.filament_diameter_mm,
          .bounds = summary.total.bounds};
}

/// What readers of files look for before anything else.
std::string Head(const ProgramSummary& summary, const MotionOptions& options, double time_s) {
  GcodeText out;
  FirmwareOf(options.flavor).WriteHead(FactsOf(summary, options, time_s), out);
  out << MetadataHead(summary) << ThumbnailsBlock(summary.thumbnails);
  return out.Take();
}

std::string Prologue(const ProgramSummary& summary, const MotionOptions& options, double time_s,
                     const StartCode& start) {
  const Firmware& firmware = FirmwareOf(options.flavor);
  const PrintFacts facts = FactsOf(summary, options, time_s);
  GcodeText out;
  out.Lines(firmware.comments().program_begin);
  out << firmware.comments().feature << "Custom\n";
  WriteMachineLimits(options, out);
  firmware.WriteChecks(options, facts, out);
  WriteStart(options, start, out);
  if (options.pressure_advance > 0) firmware.WritePressureAdvance(options.pressure_advance, out);
  DefineCopies(summary.copies, options, out);
  ExtruderWords extruder(options);
  extruder.WriteCanonicalState(out);
  firmware.WriteLayersBegin(out);
  extruder.WriteFirstRetraction(options.retraction, out);
  return out.Take();
}

/// What stands beside the last layer may be higher: end G-code moves above all of it.
std::string RiseAboveAll(const ProgramSummary& summary, const MotionOptions& options) {
  const Coord top_nm = TopOf(summary);
  if (summary.layers.empty() || summary.layers.back().frame.print_z_nm == top_nm) return {};
  return MoveToHeight(ClearHeight(top_nm, options), options);
}

/// What moves after the layers.
std::string Ending(const ProgramSummary& summary, const MotionOptions& options,
                   std::string_view end_gcode) {
  GcodeText out;
  out << RiseAboveAll(summary, options);
  const Firmware& firmware = FirmwareOf(options.flavor);
  if (options.progress) firmware.WriteProgress(100, 0, std::ssize(summary.layers), out);
  out << firmware.comments().feature << "Custom\nM107\n";
  firmware.WriteLayersEnd(out);
  out.Lines(firmware.comments().end_gcode_begin);
  out.Lines(end_gcode);
  out.Lines(firmware.comments().program_end);
  return out.Take();
}

/// The moves to each layer, from where the one before it ends, that lead round excluded areas.
std::vector<std::string> WaysBetween(const ProgramSummary& summary, const MotionOptions& options,
                                     std::string_view prologue) {
  std::vector<std::string> moves(summary.layers.size());
  if (options.room.empty()) return moves;
  const LayerWays ways(options);
  Point from = ways.After(prologue, {});
  for (size_t i = 0; i < moves.size(); ++i) {
    const LayerSummary& layer = summary.layers[i];
    if (layer.empty) continue;
    moves[i] = ways.To(layer, from);
    from = layer.exit;
  }
  return moves;
}

/// All text around the layers, but what tells times.
struct FrameText {
  std::string head;
  std::string prologue;
  std::vector<PassChange> changes;
  std::vector<std::string> ways;    ///< to each layer, where it is not straight
  std::vector<std::string> layers;  ///< ProgramEnvelope::layer_code
  std::string ending;
  std::string file_name;
};

/// `time_s`: of the print, for templates.
absl::StatusOr<FrameText> TextOf(const macro::JobCode& code, const ProgramSummary& summary,
                                 const MotionOptions& options, double time_s) {
  FrameText text;
  text.changes = PassChanges(summary);
  auto filled = FillIn(code, summary, text.changes, options, time_s);
  if (!filled.ok()) return filled.status();
  text.head = Head(summary, options, time_s);
  text.file_name = FileName(filled->file_name, options.writing.binary);
  text.prologue = Prologue(summary, options, time_s, {filled->start, filled->start_filament});
  text.ways = WaysBetween(summary, options, text.prologue);
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

PrintTimes TimesOf(const ProgramSummary& summary, const FrameText& text,
                   const MotionOptions& options) {
  PrintClock clock(summary, options);
  clock.ReadBefore(text.prologue);
  for (size_t i = 0; i < summary.layers.size(); ++i) {
    if (!text.ways[i].empty()) clock.ReadAt(i, text.ways[i]);
    clock.AddLayer(i);
  }
  clock.ReadAfter(text.ending);
  return clock.Finish();
}

double TravelMm(const ProgramSummary& summary, const MotionOptions& options) {
  const LayerWays ways(options);
  double travel_mm = summary.total.travel_mm;
  const LayerSummary* before = nullptr;
  for (const LayerSummary& layer : summary.layers) {
    if (layer.empty) continue;
    if (before != nullptr) {
      Polyline way = ways.Corners(before->exit, layer.entry);
      way.insert(way.begin(), before->exit);
      way.push_back(layer.entry);
      travel_mm += ToMm(Length(way));
    }
    before = &layer;
  }
  return travel_mm;
}

}  // namespace

absl::StatusOr<ProgramEnvelope> FrameProgram(const ProgramSummary& summary,
                                             const MotionOptions& options) {
  // Templates may name the time, which their moves are part of; what they name is the layers'.
  const auto code = macro::ParseJobCode(options);
  if (!code.ok()) return code.status();
  auto text = TextOf(*code, summary, options, summary.total.TimeS());
  if (!text.ok()) return text.status();
  ProgramEnvelope frame;
  frame.times = TimesOf(summary, *text, options);
  const double time_s = frame.times.TotalS();
  text = TextOf(*code, summary, options, time_s);
  if (!text.ok()) return text.status();

  frame.travel_mm = TravelMm(summary, options);
  frame.layer_prefixes.resize(summary.layers.size());
  if (options.progress) {
    double done_s = frame.times.before_s;
    for (size_t i = 0; i < summary.layers.size(); ++i) {
      frame.layer_prefixes[i] = ProgressLine(done_s, time_s, i, FirmwareOf(options.flavor));
      done_s += frame.times.layer_s[i];
    }
  }
  for (size_t i = 0; i < text->ways.size(); ++i) frame.layer_prefixes[i] += text->ways[i];
  frame.layer_code = std::move(text->layers);
  frame.prologue = std::move(text->prologue);
  frame.epilogue = std::move(text->ending);
  frame.head = std::move(text->head);
  frame.tail = MetadataTail(options, summary, frame.times);
  frame.file_name = std::move(text->file_name);
  return frame;
}

}  // namespace slicefarm::motion
