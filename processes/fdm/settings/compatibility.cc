#include "processes/fdm/settings/compatibility.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "common/base/text.h"
#include "common/macro/setting_variables.h"
#include "common/macro/settings_text.h"
#include "common/macro/template.h"
#include "common/macro/template_run.h"

namespace slicefarm::config::fdm {
namespace {

constexpr std::string_view kWhole = "_cummulative";

struct Condition {
  std::string_view key;  ///< key without kWhole
  std::string text;
};

bool IsCondition(std::string_view key) {
  return key == "compatible_printers_condition" || key == "compatible_prints_condition";
}

/// Returns the conditions that apply to the job, in order and without duplicates.
std::vector<Condition> ConditionsOf(std::span<const Setting> given) {
  std::vector<Condition> conditions;
  const auto add = [&](std::string_view key, std::string text) {
    const bool known = std::ranges::any_of(
        conditions, [&](const Condition& each) { return each.key == key && each.text == text; });
    if (!known && !Trim(text).empty()) conditions.push_back({key, std::move(text)});
  };
  for (const Setting& setting : given) {
    std::string_view key = setting.key;
    const bool whole = key.ends_with(kWhole);
    if (whole) key.remove_suffix(kWhole.size());
    if (!IsCondition(key)) continue;
    if (!whole) {
      add(key, macro::UnescapeSetting(Trim(setting.value)));
      continue;
    }
    std::erase_if(conditions, [&](const Condition& each) { return each.key == key; });
    for (std::string& text : macro::SettingItems(setting.key, Trim(setting.value)))
      add(key, std::move(text));
  }
  return conditions;
}

}  // namespace

std::vector<MissingFeature> IncompatibleProfiles(std::span<const Setting> given,
                                                 std::string_view settings_text) {
  const std::vector<Condition> conditions = ConditionsOf(given);
  if (conditions.empty()) return {};
  macro::TemplateVariables settings;
  macro::AddSettingVariables(settings_text, settings);
  std::vector<MissingFeature> missing;
  for (const Condition& each : conditions) {
    const auto met = macro::ExpandTemplate(each.key, "{if " + each.text + "}1{endif}", settings);
    if (!met.ok() || *met == "1") continue;
    const bool of_printer = each.key == "compatible_printers_condition";
    missing.push_back({std::string(kIncompatibleProfiles),
                       fmt::format("a profile is made for other {} than this job uses: {} = {}",
                                   of_printer ? "printers" : "print settings", each.key, each.text),
                       {{"setting", std::string(each.key)}, {"value", each.text}}});
  }
  return missing;
}

}  // namespace slicefarm::config::fdm
