#include "services/motion/algo/macro/role_code.h"

#include "common/macro/template_run.h"

namespace slicefarm::motion {

std::string_view RoleName(Feature feature) {
  constexpr std::string_view kNames[kFeatureCount] = {"ExternalPerimeter",
                                                      "Perimeter",
                                                      "OverhangPerimeter",
                                                      "GapFill",
                                                      "InternalInfill",
                                                      "SolidInfill",
                                                      "TopSolidInfill",
                                                      "BridgeInfill",
                                                      "Skirt",
                                                      "SupportMaterial",
                                                      "SupportMaterialInterface",
                                                      "Ironing",
                                                      "SolidInfill",
                                                      "BridgeInfill"};
  return kNames[static_cast<size_t>(feature)];
}

absl::StatusOr<RoleTexts> RoleTextsOf(const macro::Template& code,
                                      const std::set<RoleChange>& changes,
                                      const macro::TemplateVariables& job,
                                      const macro::TemplateVariables& layer) {
  RoleTexts roles;
  macro::TemplateVariables now = layer;
  for (const RoleChange& change : changes) {
    const auto name = [](int32_t role) {
      return std::string(role < 0 ? "" : RoleName(static_cast<Feature>(role)));
    };
    now["last_extrusion_role"] = name(change.first);
    now["extrusion_role"] = name(change.second);
    macro::TemplateMemory memory;
    auto text = macro::RunTemplate(code, {job, now}, memory);
    if (!text.ok()) return text.status();
    roles[change] = *std::move(text);
  }
  return roles;
}

}  // namespace slicefarm::motion
