#pragma once

#include <string_view>

#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// Returns a setting as a template variable, in PrusaSlicer's type (setting_types.h). For settings
/// that PrusaSlicer does not have, the type is guessed from the text.
TemplateVariable SettingVariable(std::string_view key, std::string_view value);

/// Returns the variable for `key` with one value. If the setting is a list in PrusaSlicer, the
/// variable is a list with this value.
TemplateVariable OneOfSetting(std::string_view key, TemplateValue value);

/// Adds these variables; existing variables keep their values, except for alternative names:
/// - the settings of `given` (`key = value` lines);
/// - PrusaSlicer's defaults of settings that are not given;
/// - alternative names of these values: print_bed_min, _max and _size, print_preset,
///   initial_filament_type and similar ones, num_extruders, initial_tool and other names of the
///   tool in use (setting `extruder`), timestamp, year, ... of creation_time.
void AddSettingVariables(std::string_view given, TemplateVariables& variables);

/// Returns all variables that are not settings, with the value Unknown. Only the print determines
/// their values.
TemplateVariables VariablesOfThePrint();

/// Returns true if the variable is known only after all layers are made, or if its value in a layer
/// depends on earlier layers. Layer templates with such a variable are expanded after all layers
/// exist.
bool WaitsForLayers(std::string_view variable);

}  // namespace slicefarm::macro
