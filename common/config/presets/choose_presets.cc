#include "common/config/presets/choose_presets.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/table/suggest.h"
#include "common/config/table/value.h"

namespace slicefarm::config::presets {
namespace {

constexpr size_t kShownNames = 8;  // names that an error lists

std::string Shown(std::string_view name) { return "\"" + ReplaceControls(name, '?') + "\""; }

/// Returns the first kShownNames names, in quotes, and the number of the remaining names.
std::string ShownNames(const std::vector<const Preset*>& presets) {
  std::string text;
  for (size_t i = 0; i < std::min(presets.size(), kShownNames); ++i)
    text += (i == 0 ? "" : ", ") + Shown(presets[i]->name);
  if (presets.size() > kShownNames)
    text += fmt::format(" and {} more", presets.size() - kShownNames);
  return text;
}

absl::Status UnknownName(PresetKind kind, std::string_view name,
                         const std::vector<std::string_view>& known, std::string_view where) {
  const std::string nearest = Nearest(name, known);
  std::map<std::string, std::string> metadata = {{"preset", std::string(name)},
                                                 {"kind", std::string(KindName(kind))}};
  if (!nearest.empty()) metadata["suggestion"] = nearest;
  return MakeError(absl::StatusCode::kNotFound, Reason::kProfileNotFound,
                   fmt::format("there is no {} preset {}{}{}", KindName(kind), Shown(name), where,
                               nearest.empty() ? "; `slicefarm presets list` shows the names"
                                               : fmt::format("; do you mean {}?", Shown(nearest))),
                   std::move(metadata));
}

absl::Status Unfit(const std::string& message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
}

absl::StatusOr<const Preset*> ChoosePrinter(const PresetSet& set, std::string_view name) {
  const auto found = PrintersNamed(set, name);
  if (!found.ok()) return found.status();
  const bool is_model = found->front()->name != name && found->size() > 1;
  if (!is_model) return found->front();
  return Unfit(fmt::format("{} is a printer with several presets; choose one: {}", Shown(name),
                           ShownNames(*found)));
}

/// Chooses processes and filaments for one printer.
class Chooser {
 public:
  Chooser(const PresetSet& set, const Preset& printer, const PrinterFit& fit)
      : set_(set), printer_(printer), fit_(fit) {}

  absl::StatusOr<const Preset*> Choose(PresetKind kind, const std::string& name) const {
    if (name.empty()) return Default(kind);
    const std::vector<const Preset*> named = set_.Named(kind, name);
    std::vector<const Preset*> fitting;
    std::ranges::copy_if(named, std::back_inserter(fitting),
                         [&](const Preset* preset) { return fit_.Accepts(*preset); });
    if (!fitting.empty()) return Preferred(fitting);
    const std::vector<const Preset*> all = MadeFor(set_, fit_, kind);
    std::ranges::copy_if(all, std::back_inserter(fitting),
                         [&](const Preset* preset) { return preset->alias == name; });
    if (fitting.size() == 1) return fitting.front();
    if (!fitting.empty()) return Several(name, fitting);
    if (!named.empty()) return NotMadeFor(*named.front(), all);
    std::vector<std::string_view> known;
    for (const Preset* preset : all) {
      known.push_back(preset->alias);
      known.push_back(preset->name);
    }
    return UnknownName(kind, name, known, " for " + Shown(printer_.name));
  }

 private:
  /// Returns the first preset of the printer's own group (PresetScope); if there is none, the first
  /// preset.
  const Preset* Preferred(const std::vector<const Preset*>& presets) const {
    const auto own = std::ranges::find(presets, printer_.scope, &Preset::scope);
    return own == presets.end() ? presets.front() : *own;
  }

  absl::StatusOr<const Preset*> Several(std::string_view name,
                                        const std::vector<const Preset*>& presets) const {
    std::vector<const Preset*> own;
    std::ranges::copy_if(presets, std::back_inserter(own),
                         [&](const Preset* preset) { return preset->scope == printer_.scope; });
    if (own.size() == 1) return own.front();
    return Unfit(fmt::format("several presets for {} are called {}; choose one: {}",
                             Shown(printer_.name), Shown(name), ShownNames(presets)));
  }

  absl::Status NotMadeFor(const Preset& preset, const std::vector<const Preset*>& all) const {
    if (const auto lineage = set_.Lineage(preset); !lineage.ok()) return lineage.status();
    return Unfit(fmt::format("the {} preset {} is not made for {}; made for it are {}",
                             KindName(preset.kind), Shown(preset.name), Shown(printer_.name),
                             all.empty() ? "none of the given presets" : ShownNames(all)));
  }

  /// Returns the printer's default. Vendors often name a preset that is made for another printer.
  /// Then the preset with the same alias that is made for this printer is returned.
  absl::StatusOr<const Preset*> Default(PresetKind kind) const {
    for (const std::string& name : DefaultNames(kind))
      for (const std::string& each : {name, AliasOf(name)})
        if (const auto chosen = Choose(kind, each); chosen.ok()) return chosen;
    const std::vector<const Preset*> all = MadeFor(set_, fit_, kind);
    return MakeError(
        absl::StatusCode::kNotFound, Reason::kProfileNotFound,
        fmt::format("{} names no {} preset as its default that is among the given presets; choose "
                    "one with --{}: {}",
                    Shown(printer_.name), KindName(kind), KindName(kind),
                    all.empty() ? "none of them is made for it" : ShownNames(all)),
        {{"kind", std::string(KindName(kind))}});
  }

  /// Returns the names of the printer's default presets, followed by the default filaments of its
  /// model.
  std::vector<std::string> DefaultNames(PresetKind kind) const {
    const auto lineage = set_.Lineage(printer_);
    if (!lineage.ok()) return {};
    const bool process = kind == PresetKind::kProcess;
    const std::string_view value = PresetSet::ValueOf(
        *lineage, process ? "default_print_profile" : "default_filament_profile");
    std::vector<std::string> names = ListItems(value);
    if (process && names.size() > 1) names = {Unescape(value)};
    const PrinterModel* model = process ? nullptr : set_.ModelOf(printer_);
    if (model != nullptr) std::ranges::copy(model->materials, std::back_inserter(names));
    std::erase(names, "");
    return names;
  }

  const PresetSet& set_;
  const Preset& printer_;
  const PrinterFit& fit_;
};

}  // namespace

absl::StatusOr<std::vector<const Preset*>> PrintersNamed(const PresetSet& set,
                                                         std::string_view name) {
  std::vector<const Preset*> found = set.Named(PresetKind::kPrinter, name);
  if (!found.empty()) return found;
  std::vector<std::string_view> known;
  for (const Preset& preset : set.presets()) {
    if (preset.kind != PresetKind::kPrinter || !preset.listed) continue;
    known.push_back(preset.name);
    const auto lineage = set.Lineage(preset);
    if (!lineage.ok()) continue;
    const PrinterModel* model = set.ModelOf(preset);
    if (PresetSet::ValueOf(*lineage, "printer_model") == name ||
        (model != nullptr && model->name == name))
      found.push_back(&preset);
  }
  if (!found.empty()) return found;
  return UnknownName(PresetKind::kPrinter, name, known, "");
}

std::vector<const Preset*> MadeFor(const PresetSet& set, const PrinterFit& fit, PresetKind kind) {
  std::vector<const Preset*> made;
  for (const Preset& preset : set.presets())
    if (preset.kind == kind && preset.listed && fit.Accepts(preset)) made.push_back(&preset);
  std::ranges::stable_sort(made, {}, &Preset::name);
  return made;
}

absl::StatusOr<ChosenPresets> ChoosePresets(const PresetSet& set, const PresetNames& names) {
  ChosenPresets chosen;
  const auto printer = ChoosePrinter(set, names.printer);
  if (!printer.ok()) return printer.status();
  chosen.printer = *printer;
  const auto fit = PrinterFit::Make(set, *chosen.printer);
  if (!fit.ok()) return fit.status();
  const Chooser chooser(set, *chosen.printer, *fit);
  const auto process = chooser.Choose(PresetKind::kProcess, names.process);
  if (!process.ok()) return process.status();
  chosen.process = *process;
  const auto filament = chooser.Choose(PresetKind::kFilament, names.filament);
  if (!filament.ok()) return filament.status();
  chosen.filament = *filament;
  if (!AcceptsProcess(set, *chosen.filament, *chosen.process))
    return Unfit(fmt::format("the filament preset {} is not made for the process {}",
                             Shown(chosen.filament->name), Shown(chosen.process->name)));
  return chosen;
}

}  // namespace slicefarm::config::presets
