#pragma once

#include <string_view>

#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// A setting as templates know it, in PrusaSlicer's type (setting_types.h); of other settings, what
/// the text looks like.
TemplateVariable SettingVariable(std::string_view key, std::string_view value);

/// One value under a name that PrusaSlicer may have as a list.
TemplateVariable OneOfSetting(std::string_view key, TemplateValue value);

/// Adds, where there is no value yet, the settings of `given` (`key = value` lines), PrusaSlicer's
/// defaults of those that are not given, and the names that say the same otherwise: print_bed_min,
/// _max and _size, print_preset, initial_filament_type and their like, num_extruders, initial_tool
/// and others of the tool in use (setting `extruder`), timestamp, year, ... of creation_time.
void AddSettingVariables(std::string_view given, TemplateVariables& variables);

/// All that a template may name besides settings, as Unknown: what only the print tells.
TemplateVariables VariablesOfThePrint();

/// Whether the variable is known only once all layers are made, or is another for each layer by
/// what those before it did: templates of layers that name it wait for the others.
bool WaitsForLayers(std::string_view variable);

}  // namespace slicefarm::macro
