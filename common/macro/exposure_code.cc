#include "common/macro/exposure_code.h"

#include <string>

#include "common/base/duration_text.h"
#include "common/geometry/measure.h"
#include "common/macro/setting_variables.h"
#include "common/macro/template_run.h"

namespace slicefarm::macro {
namespace {

TemplateVariable PlaceOf(Point point) {
  return TemplateVariable::List(
      {ToMm(static_cast<double>(point.x)), ToMm(static_cast<double>(point.y))});
}

/// Returns all variables of a print and a layer with the value Unknown.
TemplateVariables UnknownVariables() {
  TemplateVariables variables = ExposurePrintVariables({});
  variables.merge(ExposureLayerVariables(0, 0));
  for (auto& [name, variable] : variables)
    for (TemplateValue& item : variable.items) item = Unknown{};
  return variables;
}

}  // namespace

absl::StatusOr<ExposureCode> ParseExposureCode(const ExposureOutput& output) {
  ExposureCode code;
  const TemplateTarget targets[] = {
      {"start_gcode", output.start_gcode.str(), code.start},
      {"before_layer_gcode", output.before_layer_gcode.str(), code.before_layer},
      {"layer_gcode", output.layer_gcode.str(), code.layer},
      {"end_gcode", output.end_gcode.str(), code.end}};
  if (absl::Status status = ParseTemplates(targets); !status.ok()) return status;
  return code;
}

absl::Status CheckExposureCode(const ExposureOutput& output, std::string_view settings_text) {
  const bool is_gcode =
      output.format == OutputFormat::kGrbl || output.format == OutputFormat::kMarlin;
  if (!is_gcode) return absl::OkStatus();
  const auto code = ParseExposureCode(output);
  if (!code.ok()) return code.status();
  TemplateVariables settings;
  AddSettingVariables(settings_text, settings);
  const TemplateVariables print = UnknownVariables();
  TemplateMemory memory;
  for (const Template* part : {&code->start, &code->before_layer, &code->layer, &code->end})
    if (absl::Status ok = CheckTemplate(*part, {settings, print}, memory); !ok.ok()) return ok;
  return absl::OkStatus();
}

TemplateVariables ExposurePrintVariables(const ExposureSummary& summary) {
  TemplateVariables variables;
  const Box box = summary.bounds.Empty() ? Box{{0, 0}, {0, 0}} : summary.bounds;
  variables["total_layer_count"] = static_cast<int64_t>(summary.layers.size());
  variables["max_print_z"] =
      summary.layers.empty() ? 0.0 : ToMm(static_cast<double>(summary.layers.back().print_z_nm));
  variables["print_time"] = DurationText(summary.time_s);
  variables["first_layer_print_min"] = PlaceOf(box.min);
  variables["first_layer_print_max"] = PlaceOf(box.max);
  variables["first_layer_print_size"] = PlaceOf(box.max - box.min);
  const std::string name = summary.object_names.empty() ? "" : summary.object_names.front();
  variables["model_name"] = name;
  variables["input_filename_base"] = name.substr(0, name.rfind('.'));
  return variables;
}

TemplateVariables ExposureLayerVariables(int32_t number, Coord z_nm) {
  TemplateVariables variables;
  variables["layer_num"] = int64_t{number};
  variables["layer_z"] = variables["max_layer_z"] = ToMm(static_cast<double>(z_nm));
  return variables;
}

}  // namespace slicefarm::macro
