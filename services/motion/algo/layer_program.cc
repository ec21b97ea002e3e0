#include "services/motion/algo/layer_program.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/cooling.h"
#include "services/motion/algo/macro/gcode_template.h"
#include "services/motion/algo/toolpath/layer_timing.h"
#include "services/motion/algo/gcode/layer_writer.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/macro/template_variables.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion {
namespace {

constexpr size_t kBytesPerMove = 32;
constexpr size_t kBytesAround = 512;

/// before_layer_gcode and layer_gcode, filled in.
struct CustomCode {
  std::string before;
  std::string after;
};

absl::StatusOr<CustomCode> ExpandCustomCode(const MotionOptions& options, const LayerFrame& frame) {
  CustomCode code;
  if (options.before_layer_gcode.empty() && options.layer_gcode.empty()) return code;
  const TemplateVariables variables = LayerVariables(options, frame);
  auto before = ExpandTemplate("before_layer_gcode", options.before_layer_gcode, variables);
  if (!before.ok()) return before.status();
  auto after = ExpandTemplate("layer_gcode", options.layer_gcode, variables);
  if (!after.ok()) return after.status();
  return CustomCode{*std::move(before), *std::move(after)};
}

void WriteHeader(const LayerFrame& frame, std::string_view before, GcodeText& out) {
  const double z_mm = ToMm(static_cast<double>(frame.print_z_nm));
  out << ";LAYER_CHANGE\n;Z:";
  out.Real(z_mm, 3) << "\n;HEIGHT:";
  out.Real(static_cast<double>(ToUm(frame.height_nm)) / kUmPerMm, 3) << '\n';
  // Printer hosts look for this pair of lines; many profiles bring it along.
  if (before.find(";BEFORE_LAYER_CHANGE") == std::string_view::npos) {
    out << ";BEFORE_LAYER_CHANGE\n;";
    out.Real(z_mm, 3) << '\n';
  }
  out.Lines(before);
}

/// The second layer goes over from the first layer's temperatures to the others.
void WriteTemperatures(const MotionOptions& options, int32_t layer_index, GcodeText& out) {
  if (layer_index != 1) return;
  if (options.temperature_c != options.first_layer_temperature_c) {
    WriteTemperature("M104", options.temperature_c, out);
  }
  if (options.bed_temperature_c != options.first_layer_bed_temperature_c) {
    WriteTemperature("M140", options.bed_temperature_c, out);
  }
}

}  // namespace

absl::StatusOr<LayerProgram> ProgramLayer(const OrderedLayer& layer, const MotionOptions& options) {
  const auto code = ExpandCustomCode(options, layer.frame);
  if (!code.ok()) return code.status();
  ToolpathBuilder builder(options, layer.frame);
  for (const Path& path : layer.paths) builder.Add(path);
  Toolpath path = builder.Finish();

  LayerProgram program;
  program.frame = layer.frame;
  program.stats = builder.stats();
  LayerTiming timing(options.flavor, options.limits);
  AddTimes(path, SlowDown(options.cooling, timing, path), program.stats);

  const int32_t index = layer.frame.index;
  LayerState state;
  state.fan_percent = FanPercent(options.cooling, index, program.stats.TimeS());
  state.bridge_fan_percent = BridgeFanPercent(options.cooling, index, state.fan_percent);
  state.height_um = ToUm(layer.frame.height_nm);
  LayerWriter writer(options.flavor, AccelerationsFor(options, index), state);

  GcodeText out(path.moves.size() * kBytesPerMove + kBytesAround + code->before.size() +
                code->after.size());
  WriteHeader(layer.frame, code->before, out);
  WriteTemperatures(options, index, out);
  WriteFan(state.fan_percent, out);
  const size_t approach = std::min(path.approach, path.moves.size());
  writer.Write(path, 0, approach, out);
  out.Lines(code->after);
  if (!code->after.empty()) writer.Forget();
  writer.Write(path, approach, path.moves.size(), out);
  program.gcode = out.Take();
  if (!layer.paths.empty()) {
    program.entry = StartOf(layer.paths.front());
    program.exit = EndOf(layer.paths.back());
  }
  return program;
}

}  // namespace slicefarm::motion
