#include "services/motion/algo/pass_change.h"

#include <algorithm>

#include "common/gcode/gcode_text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/gcode/extruder_words.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/layer_travels.h"
#include "services/motion/algo/text/commands.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {
namespace {

constexpr Coord kClearanceNm = kNmPerMm;

void WriteFirstLayerTemperatures(const MotionOptions& options, std::string_view custom,
                                 GcodeText& out) {
  if (options.tool().first_layer_bed_temperature_c != options.tool().bed_temperature_c &&
      !Commands(custom, {"M140", "M190"}))
    WriteTemperature("M140", options.tool().first_layer_bed_temperature_c, out);
  if (options.tool().first_layer_temperature_c != options.tool().temperature_c &&
      !Commands(custom, {"M104", "M109"}))
    WriteTemperature("M104", options.tool().first_layer_temperature_c, out);
}

}  // namespace

std::vector<PassChange> PassChanges(const ProgramSummary& summary) {
  std::vector<PassChange> changes;
  Coord top_nm = 0;
  for (size_t i = 0; i < summary.layers.size(); ++i) {
    const LayerSummary& layer = summary.layers[i];
    if (i > 0 && layer.pass != summary.layers[i - 1].pass) {
      changes.push_back({.layer = i,
                         .from = summary.layers[i - 1].exit,
                         .to = layer.entry,
                         .top_nm = top_nm,
                         .on_bed = layer.frame.index == 0});
    }
    top_nm = std::max(top_nm, layer.frame.print_z_nm);
  }
  return changes;
}

Coord ClearHeight(Coord top_nm, const MotionOptions& options) {
  const Coord clear = top_nm + kClearanceNm;
  if (options.max_print_height_nm <= 0) return clear;
  return std::max(top_nm, std::min(clear, options.max_print_height_nm));
}

std::string MoveToHeight(Coord z_nm, const MotionOptions& options) {
  GcodeText out;
  out << "G1 Z";
  out.Micrometers(ToUm(z_nm + FromMm(options.z_offset_mm))) << " F";
  out.Integer(FeedRate(TravelSpeedZ(options))) << '\n';
  return out.Take();
}

std::string GcodeOf(const PassChange& change, std::string_view custom,
                    const MotionOptions& options) {
  const std::string rise = MoveToHeight(ClearHeight(change.top_nm, options), options);
  GcodeText out;
  out << rise;
  if (change.on_bed) WriteFirstLayerTemperatures(options, custom, out);
  if (!custom.empty()) {
    out.Lines(custom);
    ExtruderWords(options).WriteCanonicalState(out);
    out << rise;
  }
  const LayerTravels travels(options);
  std::vector<Point> travel = travels.Corners(travels.After(custom, change.from), change.to);
  travel.push_back(change.to);
  out << travels.MovesTo(travel);
  return out.Take();
}

}  // namespace slicefarm::motion
