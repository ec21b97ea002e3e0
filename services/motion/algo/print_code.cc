#include "services/motion/algo/print_code.h"

#include <algorithm>
#include <utility>

#include "common/model/options/motion_options.h"
#include "services/motion/algo/macro/file_name.h"
#include "services/motion/algo/macro/height_text.h"
#include "services/motion/algo/macro/template_variables.h"

namespace slicefarm::motion {
namespace {

/// Walks through the print and fills in its templates.
class CodeWalk {
 public:
  CodeWalk(const macro::JobCode& code, const ProgramSummary& summary, const MotionOptions& options,
           double time_s, std::optional<double> silent_s, const HeightTexts& heights)
      : code_(code),
        heights_(heights),
        summary_(summary),
        options_(options),
        time_s_(time_s),
        silent_s_(silent_s.value_or(time_s)),
        job_(JobVariables(options, summary.settings_text)),
        now_(PrintVariables(options, summary, time_s, silent_s)) {}

  absl::StatusOr<PrintCode> Run(std::span<const PassChange> changes) {
    PrintCode filled;
    // Start G-code is before the first layer, so the layer number is -1.
    Put({.number = -1, .print_z_nm = 0, .top_nm = TopOf(summary_)}, 0, 0);
    if (absl::Status ok = Add(code_.file_start, filled.file_start); !ok.ok()) return ok;
    if (absl::Status ok = Add(code_.start, filled.start); !ok.ok()) return ok;
    if (absl::Status ok = Add(code_.start_filament, filled.start_filament); !ok.ok()) return ok;
    if (absl::Status ok = AddLayers(changes, filled); !ok.ok()) return ok;
    Put(Last(), summary_.total.FilamentMm(),
        summary_.layers.empty() ? 0 : summary_.layers.back().filament_mm);
    if (absl::Status ok = Add(code_.end, filled.end); !ok.ok()) return ok;
    now_["print_time"] = now_["normal_print_time"] = ShortTime(time_s_);
    now_["silent_print_time"] = ShortTime(silent_s_);
    if (absl::Status ok = Add(code_.file_name, filled.file_name); !ok.ok()) return ok;
    return filled;
  }

 private:
  absl::Status AddLayers(std::span<const PassChange> changes, PrintCode& filled) {
    double filament_mm = 0, layer_mm = 0;
    auto change = changes.begin();
    LayerContext before;
    for (size_t i = 0; i < summary_.layers.size(); ++i) {
      const LayerSummary& layer = summary_.layers[i];
      if (change != changes.end() && change->layer == i) {
        before.pass = layer.pass;
        Put(before, filament_mm, layer_mm);
        if (absl::Status ok = Add(code_.between_objects, filled.between.emplace_back()); !ok.ok())
          return ok;
        ++change;
      }
      before = {.pass = layer.pass,
                .number = static_cast<int32_t>(i),
                .print_z_nm = layer.frame.print_z_nm,
                .top_nm = std::max(before.top_nm, layer.frame.print_z_nm)};
      if (code_.layers_wait) {
        Put(before, filament_mm, layer_mm);
        if (absl::Status ok = AddLayer(layer.frame, filled); !ok.ok()) return ok;
      }
      layer_mm = layer.filament_mm;
      filament_mm += layer_mm;
    }
    return absl::OkStatus();
  }

  absl::Status AddLayer(const LayerFrame& layer, PrintCode& filled) {
    if (absl::Status ok = Add(code_.before_layer, filled.layers.emplace_back()); !ok.ok())
      return ok;
    auto after = CodeAfterChange(layer, code_, heights_, {job_, now_}, memory_);
    if (!after.ok()) return after.status();
    filled.layers.push_back(*std::move(after));
    return absl::OkStatus();
  }

  LayerContext Last() const {
    LayerContext last;
    if (summary_.layers.empty()) return last;
    last.number = static_cast<int32_t>(summary_.layers.size()) - 1;
    last.print_z_nm = summary_.layers.back().frame.print_z_nm;
    last.top_nm = TopOf(summary_);
    return last;
  }

  /// Sets the variables for the next templates.
  void Put(const LayerContext& context, double filament_mm, double layer_mm) {
    for (auto& [name, variable] : LayerVariables(context, {})) now_[name] = std::move(variable);
    PutUseSoFar(options_, filament_mm, layer_mm, now_);
  }

  absl::Status Add(const macro::Template& part, std::string& text) {
    auto filled = macro::RunTemplate(part, {job_, now_}, memory_);
    if (!filled.ok()) return filled.status();
    text = *std::move(filled);
    return absl::OkStatus();
  }

  const macro::JobCode& code_;
  const HeightTexts& heights_;
  const ProgramSummary& summary_;
  const MotionOptions& options_;
  const double time_s_;
  const double silent_s_;
  const macro::TemplateVariables job_;
  macro::TemplateVariables now_;
  macro::TemplateMemory memory_;
};

}  // namespace

absl::StatusOr<PrintCode> FillIn(const macro::JobCode& code, const ProgramSummary& summary,
                                 std::span<const PassChange> changes, const MotionOptions& options,
                                 double time_s, std::optional<double> silent_s) {
  const auto heights = HeightTexts::Of(options);
  if (!heights.ok()) return heights.status();
  return CodeWalk(code, summary, options, time_s, silent_s, *heights).Run(changes);
}

}  // namespace slicefarm::motion
