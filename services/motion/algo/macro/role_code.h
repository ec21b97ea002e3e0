#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "common/macro/template.h"
#include "common/macro/template_value.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// Two features in the order of printing, as numbers of Feature; the first is -1 at the start of a
/// layer.
using RoleChange = std::pair<int32_t, int32_t>;

/// Filled-in change_extrusion_role_gcode of a layer, by change.
using RoleTexts = std::map<RoleChange, std::string>;

/// Returns the name of a feature in templates, as in OrcaSlicer: "ExternalPerimeter".
std::string_view RoleName(Feature feature);

/// Fills in the template for each change, with the variables extrusion_role and
/// last_extrusion_role. `job`, `layer`: other variables. Errors: as RunTemplate.
absl::StatusOr<RoleTexts> RoleTextsOf(const macro::Template& code,
                                      const std::set<RoleChange>& changes,
                                      const macro::TemplateVariables& job,
                                      const macro::TemplateVariables& layer);

}  // namespace slicefarm::motion
