#include "services/motion/algo/macro/layer_code.h"

#include <algorithm>
#include <utility>

#include "common/base/text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/macro/template_variables.h"

namespace slicefarm::motion {

namespace {

/// Returns true if a line of the code moves the nozzle.
bool MovesNozzle(std::string_view code) {
  return std::ranges::any_of(Split(code, "\n"), [](std::string_view line) {
    line = Trim(line.substr(0, line.find(';')));
    return line.size() > 2 && line[0] == 'G' && line[1] >= '0' && line[1] <= '3' &&
           line[2] == ' ' && line.find_first_of("XYZ") != line.npos;
  });
}

}  // namespace

absl::StatusOr<LayerCode> LayerCode::Of(const MotionOptions& options) {
  LayerCode layer;
  auto heights = HeightTexts::Of(options);
  if (!heights.ok()) return heights.status();
  layer.heights_ = *std::move(heights);
  layer.any_ = !options.before_layer_gcode.empty() || !options.layer_gcode.empty() ||
               !layer.heights_.empty();
  layer.names_layer_change_ =
      options.before_layer_gcode.str().find(";BEFORE_LAYER_CHANGE") != std::string::npos;
  layer.has_after_ = !options.layer_gcode.empty();
  layer.moves_ = MovesNozzle(options.layer_gcode.str());
  layer.has_roles_ = !options.role_gcode.empty();
  if (!layer.any_ && !layer.has_roles_) return layer;
  auto code = macro::ParseJobCode(options);
  if (!code.ok()) return code.status();
  layer.code_ = *std::move(code);
  if (!layer.code_.layers_wait || layer.has_roles_)
    layer.job_ = JobVariables(options, options.layer_settings);
  return layer;
}

absl::StatusOr<CustomCode> LayerCode::At(const LayerFrame& layer, const LayerContext& context,
                                         const JobFacts& facts) const {
  CustomCode code;
  code.waits = code_.layers_wait;
  code.names_layer_change = names_layer_change_;
  code.has_after = has_after_ || heights_.IsAt(layer);
  code.primes = heights_.PrimesAt(layer);
  code.moves = moves_;
  if (!any_ || code.waits) return code;
  const macro::TemplateVariables now = LayerVariables(context, facts);
  macro::TemplateMemory memory;
  auto before = macro::RunTemplate(code_.before_layer, {job_, now}, memory);
  if (!before.ok()) return before.status();
  auto after = CodeAfterChange(layer, code_, heights_, {job_, now}, memory);
  if (!after.ok()) return after.status();
  code.before = *std::move(before);
  code.after = *std::move(after);
  code.moves = code.moves || MovesNozzle(code.after);
  return code;
}

absl::StatusOr<RoleTexts> LayerCode::RolesAt(const LayerContext& context, const JobFacts& facts,
                                             const std::set<RoleChange>& changes) const {
  return RoleTextsOf(code_.role, changes, job_, LayerVariables(context, facts));
}

}  // namespace slicefarm::motion
