#pragma once

#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/config/table/field.h"
#include "common/config/table/orca_name.h"

namespace slicefarm::config {

enum class Kind {
  kFlag,  ///< 0 or 1
  kInteger,
  kNumber,
  kPercent,          ///< `20%`, or `20`
  kNumberOrPercent,  ///< a number, or a percentage of the setting `relative_to`
  kChoice,           ///< one of `choices`
  kText,             ///< one line
  kGcode,            ///< lines of G-code, `\n` between them
  kBedShape,
  kAreas,  ///< areas of the bed (ParseAreas); empty: none
  kPoint,  ///< `XxY`
  kSizes,
  // JSON on one line (common/model/fields/field_text.h); empty: none
  kDensityField,
  kStressField,
  kMaterialField,
  kAngles,         ///< angles by layer (common/model/options/fill_angles.h); empty: none
  kFlowTable,      ///< factors by length (common/model/options/flow_table.h)
  kHeightCode,     ///< JSON on one line (common/model/options/height_code.h); empty: none
  kLayerHeights,   ///< z and height alternately (common/model/options/layer_heights.h); empty: none
  kSubstitutions,  ///< texts by fours (common/gcode/substitutions.h); empty: none
  kCutter,         ///< a milling cutter (common/model/options/cutter_text.h)
};

/// Returns the kind's name for clients that build forms: "flag", "number_or_percent".
constexpr std::string_view KindName(Kind kind) {
  constexpr std::string_view kNames[] = {
      "flag",   "integer",    "number",        "percent",       "number_or_percent",
      "choice", "text",       "gcode",         "bed_shape",     "areas",
      "point",  "sizes",      "density_field", "stress_field",  "material_field",
      "angles", "flow_table", "height_code",   "layer_heights", "substitutions",
      "cutter"};
  return kNames[static_cast<size_t>(kind)];
}

/// One name of a choice. PrusaSlicer's names that are not made yet stand in the table too: `note`
/// then says what is done instead, and the value counts as one without full effect.
struct Choice {
  std::string_view name;
  int value = 0;
  std::string_view note = {};
};

/// Whether the setting is a list in a config.ini; its first item counts.
enum class List {
  kNone,
  kPerExtruder,  ///< one item per extruder
  kPerMode,      ///< normal and silent mode of the machine
};

/// machine_limits_usage = ignore.
inline constexpr int kIgnoreLimits = 2;

/// Text for "no value" in a config.ini.
inline constexpr std::string_view kNotSet = "nil";

/// One setting: all that reading, checking, documenting and printing it takes.
struct SettingSpec {
  std::string_view key;
  Kind kind = Kind::kNumber;
  std::string_view unit = {};
  double min =
      0;  ///< least number, in `unit`; percentages are checked by the number that they amount to
  double max = 0;
  std::string_view standard = {};  ///< the value when none is given, as a config.ini writes it
  std::string_view doc = {};
  std::vector<Choice> choices = {};
  std::string_view relative_to = {};
  std::string_view percent_of = {};  ///< base of the percentage, in words, if it is no setting
  List list = List::kNone;
  Field field = {};             ///< none: it works through other settings only (derive.h)
  Field also = {};              ///< a second place for the same value
  std::string_view group = {};  ///< part of the table: "walls", "infill"
  std::optional<Scope> own_scope =
      {};  ///< scope, if the setting has no field or another scope than its row
  std::vector<OrcaName> orca = {};  ///< names in OrcaSlicer; the later one wins

  Scope scope() const { return own_scope.value_or(field.scope); }
};

/// Returns the setting with a scope that differs from its row's.
inline SettingSpec InScope(Scope scope, SettingSpec spec) {
  spec.own_scope = scope;
  return spec;
}

/// Returns the setting with its name in OrcaSlicer.
inline SettingSpec Orca(OrcaName name, SettingSpec spec) {
  spec.orca.push_back(name);
  return spec;
}

/// Part of a settings table: a function that makes it, and its name.
struct SettingGroup {
  std::string_view name;
  std::vector<SettingSpec> (*make)();
};

/// Returns the settings of all groups, which carry the groups' names.
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
