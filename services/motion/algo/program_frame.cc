#include "services/motion/algo/program_frame.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "services/motion/algo/macro/gcode_template.h"
#include "services/motion/algo/gcode/gcode_text.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/gcode/object_labels.h"
#include "services/motion/algo/gcode/print_metadata.h"
#include "services/motion/algo/pass_change.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/travel_time.h"
#include "services/motion/algo/macro/template_variables.h"
#include "services/motion/algo/gcode/thumbnails_block.h"

namespace slicefarm::motion {
namespace {

/// Walks through the layers: `start_s` of each, then the whole.
struct Timeline {
  std::vector<PassChange> changes;
  std::vector<double> start_s;
  double time_s = 0;
  double travel_mm = 0;
};

Timeline TimelineOf(const ProgramSummary& summary, const MotionOptions& options) {
  Timeline timeline;
  timeline.changes = PassChanges(summary);
  timeline.travel_mm = summary.total.travel_mm;
  auto change = timeline.changes.begin();
  const LayerSummary* before = nullptr;
  for (size_t i = 0; i < summary.layers.size(); ++i) {
    const LayerSummary& layer = summary.layers[i];
    if (change != timeline.changes.end() && change->layer == i) {
      timeline.travel_mm += ToMm(Distance(change->from, change->to));
      timeline.time_s += TimeOf(*change++, options);
      before = &layer;
    } else if (!layer.empty) {
      if (before != nullptr) {
        timeline.travel_mm += ToMm(Distance(before->exit, layer.entry));
        timeline.time_s += TravelTime(before->exit, layer.entry, options, layer.frame.index);
      }
      before = &layer;
    }
    timeline.start_s.push_back(timeline.time_s);
    timeline.time_s += layer.time_s;
  }
  return timeline;
}

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

std::string Epilogue(const ProgramSummary& summary, const MotionOptions& options,
                     std::string_view end_gcode, double time_s) {
  GcodeText out;
  out << RiseAboveAll(summary, options);
  if (options.progress) out << "M73 P100 R0\n";
  out << ";TYPE:Custom\nM107\n";
  out.Lines(end_gcode) << MetadataTail(options, summary, time_s);
  return out.Take();
}

}  // namespace

absl::StatusOr<ProgramFrame> FrameProgram(const ProgramSummary& summary,
                                          const MotionOptions& options) {
  const Timeline timeline = TimelineOf(summary, options);
  const TemplateVariables variables = ProgramVariables(options, summary, timeline.time_s);
  const auto start = ExpandTemplate("start_gcode", options.start_gcode, variables);
  if (!start.ok()) return start.status();
  const auto end = ExpandTemplate("end_gcode", options.end_gcode, variables);
  if (!end.ok()) return end.status();

  ProgramFrame frame;
  frame.time_s = timeline.time_s;
  frame.travel_mm = timeline.travel_mm;
  frame.layer_prefixes.resize(summary.layers.size());
  if (options.progress) {
    for (size_t i = 0; i < summary.layers.size(); ++i) {
      frame.layer_prefixes[i] = ProgressLine(timeline.start_s[i], timeline.time_s);
    }
  }
  for (const PassChange& change : timeline.changes) {
    const auto way = GcodeOf(change, summary, variables, options);
    if (!way.ok()) return way.status();
    frame.layer_prefixes[change.layer].insert(0, *way);
  }
  frame.prologue = Prologue(summary, options, *start);
  frame.epilogue = Epilogue(summary, options, *end, timeline.time_s);
  return frame;
}

}  // namespace slicefarm::motion
