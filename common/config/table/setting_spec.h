#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/config/table/field.h"
#include "common/config/table/need.h"
#include "common/config/table/orca_name.h"

namespace slicefarm::config {

/// Kind of value that a setting has.
enum class Kind {
  kFlag,  ///< flag, 0 or 1
  kInteger,
  kNumber,
  kPercent,          ///< percentage, `20%` or `20`
  kNumberOrPercent,  ///< number, or a percentage of the setting `relative_to`
  kChoice,           ///< one of `choices`
  kText,             ///< text of one line
  kGcode,            ///< lines of G-code, separated by `\n`
  kBedShape,
  kAreas,  ///< areas of the bed (ParseAreas); empty: no areas
  kPoint,  ///< point, `XxY`
  kSizes,
  // Fields as JSON on one line (common/model/fields/field_text.h). Empty: no field.
  kDensityField,
  kStressField,
  kMaterialField,
  kAngles,       ///< angles by layer (common/model/options/fill_angles.h); empty: no angles
  kSolidLayers,  ///< layers (common/model/options/solid_layers.h); empty: no layers
  kFlowTable,    ///< factors by length (common/model/options/flow_table.h)
  /// Pressure advance by flow and acceleration (common/model/options/advance_model.h); empty: none
  kAdvancePoints,
  /// G-code at heights, as JSON on one line (common/model/options/height_code.h); empty: none
  kHeightCode,
  /// Alternately z and height (common/model/options/layer_heights.h); empty: no heights.
  kLayerHeights,
  /// Text substitutions, four texts each (common/gcode/substitutions.h); empty: none.
  kSubstitutions,
  kCutter,  ///< milling cutter (common/model/options/cutter_text.h)
};

/// Returns the kind's name for clients that build forms, such as "flag" or "number_or_percent".
constexpr std::string_view KindName(Kind kind) {
  constexpr std::string_view kNames[] = {
      "flag",          "integer",       "number",        "percent",        "number_or_percent",
      "choice",        "text",          "gcode",         "bed_shape",      "areas",
      "point",         "sizes",         "density_field", "stress_field",   "material_field",
      "angles",        "solid_layers",  "flow_table",    "advance_points", "height_code",
      "layer_heights", "substitutions", "cutter"};
  return kNames[static_cast<size_t>(kind)];
}

/// Name of a choice. The table also contains PrusaSlicer's choices that are not supported yet. For
/// these, `note` describes the substitute that is used; a setting with such a choice is reported as
/// partly effective.
struct Choice {
  std::string_view name;
  int value = 0;
  std::string_view note = {};
};

/// Form of a setting's list in a config.ini. Only one item of the list is used.
enum class List {
  kNone,
  kPerExtruder,  ///< list with one item per extruder
  kPerMode,      ///< list with two items, for normal and silent mode
};

/// Choice::value of machine_limits_usage = ignore.
inline constexpr int kIgnoreLimits = 2;

/// Text of a setting without a value in a config.ini.
inline constexpr std::string_view kNotSet = "nil";

/// Definition of a setting: everything needed to read, check, document and print it.
struct SettingSpec {
  std::string_view key;
  Kind kind = Kind::kNumber;
  std::string_view unit = {};
  double min = 0;  ///< smallest number, in `unit`; a percentage is first converted to `unit`
  double max = 0;
  std::string_view standard = {};  ///< default value, in the form of a config.ini
  std::string_view doc = {};
  std::vector<Choice> choices = {};
  std::string_view relative_to = {};
  /// Description of the percentage's base, if the base is not a setting (`relative_to`).
  std::string_view percent_of = {};
  List list = List::kNone;
  /// Member that stores the value. Empty: the value acts only through other settings
  /// (derive_steps.h).
  Field field = {};
  Field also = {};              ///< second member that stores the same value; may be empty
  std::string_view group = {};  ///< part of the table, such as "walls" or "infill"
  std::optional<Scope> own_scope =
      {};  ///< scope, if the setting has no field, or if its scope is not the scope of the field
  std::vector<OrcaName> orca = {};      ///< names in OrcaSlicer; a later name wins
  std::vector<const Need*> needs = {};  ///< requirements without which the setting has no effect

  Scope scope() const { return own_scope.value_or(field.scope); }
};

/// Returns the setting with this scope instead of the scope of its field.
inline SettingSpec InScope(Scope scope, SettingSpec spec) {
  spec.own_scope = scope;
  return spec;
}

/// Returns the setting with its requirements.
inline SettingSpec Needing(std::initializer_list<const Need*> needs, SettingSpec spec) {
  spec.needs = needs;
  return spec;
}

/// Returns the setting with its name in OrcaSlicer.
inline SettingSpec Orca(OrcaName name, SettingSpec spec) {
  spec.orca.push_back(name);
  return spec;
}

/// Section of a settings table: its name and the function that makes its settings.
struct SettingGroup {
  std::string_view name;
  std::vector<SettingSpec> (*make)();
};

/// Returns the settings of all groups, each with the name of its group.
template <typename Groups>
std::vector<SettingSpec> TableOf(const Groups& groups) {
  std::vector<SettingSpec> all;
  for (const SettingGroup& group : groups) {
    for (SettingSpec& spec : group.make()) {
      spec.group = group.name;
      all.push_back(std::move(spec));
    }
  }
  return all;
}

}  // namespace slicefarm::config
