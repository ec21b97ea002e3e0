#include "common/config/presets/compatible.h"

#include <algorithm>
#include <string_view>

#include "common/base/text.h"
#include "common/config/table/value.h"
#include "common/macro/setting_variables.h"
#include "common/macro/settings_text.h"
#include "common/macro/template_run.h"

namespace slicefarm::config::presets {
namespace {

constexpr std::string_view kLibrary = "OrcaFilamentLibrary";

/// Returns a value in the form of a config.ini. JSON lists become lists of numbers or of texts.
std::string IniValue(std::string_view value) {
  if (!value.starts_with('[')) return std::string(value);
  const std::vector<std::string> items = ListItems(value);
  const bool numbers = std::ranges::all_of(items, [](std::string_view item) {
    if (item.ends_with('%')) item.remove_suffix(1);
    return ToNumber(item).has_value();
  });
  std::string text;
  for (const std::string& item : items) {
    if (!text.empty()) text += numbers ? "," : ";";
    text += numbers ? item : QuoteText(item);
  }
  return text;
}

/// Returns the settings of a preset as variables of a condition.
macro::TemplateVariables VariablesOf(const FlatPreset& flat) {
  std::string lines;
  for (const auto& [key, value] : flat) lines += key + " = " + IniValue(value.value) + "\n";
  macro::TemplateVariables variables;
  macro::AddSettingVariables(lines, variables);
  return variables;
}

/// Returns the result of a condition; true if it is empty or cannot be evaluated.
bool IsMet(std::string_view key, std::string_view condition,
           const macro::TemplateVariables& variables) {
  const std::string text = macro::UnescapeSetting(Trim(condition));
  if (text.empty()) return true;
  const auto met = macro::ExpandTemplate(key, "{if " + text + "}1{endif}", variables);
  return !met.ok() || *met == "1";
}

}  // namespace

absl::StatusOr<PrinterFit> PrinterFit::Make(const PresetSet& set, const Preset& printer) {
  const auto lineage = set.Lineage(printer);
  if (!lineage.ok()) return lineage.status();
  const auto flat = set.Flatten(printer);
  if (!flat.ok()) return flat.status();
  PrinterFit fit(set, printer);
  for (const Preset* each : *lineage)
    if (fit.vendor_.empty()) fit.vendor_ = set.ScopeOf(*each).vendor;
  fit.variables_ = VariablesOf(*flat);
  fit.variables_.try_emplace("printer_preset", printer.name);
  if (printer.dialect != PresetDialect::kOrca) return fit;
  for (const Preset& preset : set.presets()) {
    const bool held = preset.kind == PresetKind::kFilament && preset.listed &&
                      set.ScopeOf(preset).vendor != kLibrary;
    if (!held) continue;
    const auto ancestors = set.Lineage(preset);
    if (ancestors.ok() &&
        fit.IsNamedIn(ListItems(PresetSet::ValueOf(*ancestors, "compatible_printers"))))
      fit.held_.insert(preset.alias);
  }
  return fit;
}

bool PrinterFit::IsNamedIn(const std::vector<std::string>& names) const {
  return std::ranges::find(names, printer_->name) != names.end();
}

bool PrinterFit::HasAllowedVendor(const Preset& preset) const {
  const PresetScope& scope = set_->ScopeOf(preset);
  if (preset.dialect != PresetDialect::kOrca)
    return scope.vendor.empty() || scope.vendor == vendor_ || scope.templates;
  return scope.vendor != kLibrary || !held_.contains(preset.alias);
}

bool PrinterFit::Accepts(const Preset& preset) const {
  const bool same_program =
      (preset.dialect == PresetDialect::kOrca) == (printer_->dialect == PresetDialect::kOrca);
  if (!same_program || !HasAllowedVendor(preset)) return false;
  const auto lineage = set_->Lineage(preset);
  if (!lineage.ok()) return false;
  const std::vector<std::string> names =
      ListItems(PresetSet::ValueOf(*lineage, "compatible_printers"));
  if (names.empty()) {
    constexpr std::string_view kCondition = "compatible_printers_condition";
    return IsMet(kCondition, PresetSet::ValueOf(*lineage, kCondition), variables_);
  }
  if (IsNamedIn(names)) return true;
  const bool of_user = set_->ScopeOf(*printer_).vendor.empty();
  return preset.dialect == PresetDialect::kOrca && of_user && !printer_->parents.empty() &&
         std::ranges::find(names, printer_->parents.front()) != names.end();
}

bool AcceptsProcess(const PresetSet& set, const Preset& filament, const Preset& process) {
  const auto lineage = set.Lineage(filament);
  if (!lineage.ok()) return false;
  const std::vector<std::string> names =
      ListItems(PresetSet::ValueOf(*lineage, "compatible_prints"));
  if (!names.empty()) return std::ranges::find(names, process.name) != names.end();
  constexpr std::string_view kCondition = "compatible_prints_condition";
  const std::string_view condition = PresetSet::ValueOf(*lineage, kCondition);
  if (Trim(condition).empty()) return true;
  const auto flat = set.Flatten(process);
  return !flat.ok() || IsMet(kCondition, condition, VariablesOf(*flat));
}

}  // namespace slicefarm::config::presets
