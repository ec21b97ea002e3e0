#include "services/motion/algo/program_frame.h"

#include <cmath>
#include <string>
#include <utility>

#include "services/motion/algo/macro/gcode_template.h"
#include "services/motion/algo/gcode/gcode_text.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/gcode/object_labels.h"
#include "services/motion/algo/gcode/print_metadata.h"
#include "services/motion/algo/pass_change.h"
#include "services/motion/algo/program/print_clock.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/macro/template_variables.h"
#include "services/motion/algo/gcode/thumbnails_block.h"

namespace slicefarm::motion {
namespace {

/// M73: percent done, minutes left.
std::string ProgressLine(double done_s, double time_s) {
  GcodeText out;
  const double share = time_s > 0 ? done_s / time_s : 0;
  out << "M73 P";
  out.Integer(std::lround(std::floor(100 * share))) << " R";
  out.Integer(std::lround(std::ceil((time_s - done_s) / 60))) << '\n';
  return out.Take();
}

std::string Prologue(const ProgramSummary& summary, const MotionOptions& options,
                     std::string_view start_gcode) {
  GcodeText out;
  out << MetadataHead(summary) << ThumbnailsBlock(summary.thumbnails) << ";TYPE:Custom\n";
  WriteMachineLimits(options, out);
  WriteStart(options, start_gcode, out);
  DefineCopies(summary.copies, options, out);
  out << "G21\nG90\nM83\n";
  const double length_mm = options.retraction.length_mm;
  if (length_mm > 0) {
    out << "G1 E";
    out.Real(-length_mm, 5) << " F";
    out.Integer(FeedRate(options.retraction.speed_mm_s)) << '\n';
  }
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
  if (options.progress) out << "M73 P100 R0\n";
  out << ";TYPE:Custom\nM107\n";
  out.Lines(end_gcode);
  return out.Take();
}

/// All text around the layers, but what tells times.
struct FrameText {
  std::string prologue;
  std::vector<PassChange> changes;
  std::vector<std::string> ways;  ///< of the changes
  std::string ending;
};

/// `time_s`: of the print, for templates.
absl::StatusOr<FrameText> TextOf(const ProgramSummary& summary, const MotionOptions& options,
                                 double time_s) {
  const TemplateVariables variables = ProgramVariables(options, summary, time_s);
  const auto start = ExpandTemplate("start_gcode", options.start_gcode, variables);
  if (!start.ok()) return start.status();
  const auto end = ExpandTemplate("end_gcode", options.end_gcode, variables);
  if (!end.ok()) return end.status();
  FrameText text;
  text.prologue = Prologue(summary, options, *start);
  text.changes = PassChanges(summary);
  for (const PassChange& change : text.changes) {
    auto way = GcodeOf(change, summary, variables, options);
    if (!way.ok()) return way.status();
    text.ways.push_back(*std::move(way));
  }
  text.ending = Ending(summary, options, *end);
  return text;
}

PrintTimes TimesOf(const ProgramSummary& summary, const FrameText& text,
                   const MotionOptions& options) {
  PrintClock clock(summary, options);
  clock.ReadBefore(text.prologue);
  auto change = text.changes.begin();
  auto way = text.ways.begin();
  for (size_t i = 0; i < summary.layers.size(); ++i) {
    if (change != text.changes.end() && change->layer == i) {
      clock.ReadAt(i, *way++);
      ++change;
    }
    clock.AddLayer(i);
  }
  clock.ReadAfter(text.ending);
  return clock.Finish();
}

double TravelMm(const ProgramSummary& summary) {
  double travel_mm = summary.total.travel_mm;
  const LayerSummary* before = nullptr;
  for (const LayerSummary& layer : summary.layers) {
    if (layer.empty) continue;
    if (before != nullptr) travel_mm += ToMm(Distance(before->exit, layer.entry));
    before = &layer;
  }
  return travel_mm;
}

}  // namespace

absl::StatusOr<ProgramFrame> FrameProgram(const ProgramSummary& summary,
                                          const MotionOptions& options) {
  // Templates may name the time, which their moves are part of; what they name is the layers'.
  auto text = TextOf(summary, options, summary.total.TimeS());
  if (!text.ok()) return text.status();
  ProgramFrame frame;
  frame.times = TimesOf(summary, *text, options);
  const double time_s = frame.times.TotalS();
  text = TextOf(summary, options, time_s);
  if (!text.ok()) return text.status();

  frame.travel_mm = TravelMm(summary);
  frame.layer_prefixes.resize(summary.layers.size());
  for (size_t i = 0; i < text->changes.size(); ++i)
    frame.layer_prefixes[text->changes[i].layer] = std::move(text->ways[i]);
  if (options.progress) {
    double done_s = frame.times.before_s;
    for (size_t i = 0; i < summary.layers.size(); ++i) {
      frame.layer_prefixes[i] += ProgressLine(done_s, time_s);
      done_s += frame.times.layer_s[i];
    }
  }
  frame.prologue = std::move(text->prologue);
  frame.epilogue = text->ending + MetadataTail(options, summary, frame.times);
  return frame;
}

}  // namespace slicefarm::motion
