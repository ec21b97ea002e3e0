#include "common/config/presets/choose_presets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
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
                         const std::vector<std::string_view>& known, std::string_view printer) {
  const std::string nearest = Nearest(name, known);
  std::map<std::string, std::string> metadata = {{"preset", std::string(name)},
                                                 {"kind", std::string(KindName(kind))}};
  if (!nearest.empty()) metadata["suggestion"] = nearest;
  const bool any = printer.empty();
  const std::string list = fmt::format("; `slicefarm presets list{}` shows the names",
                                       any ? "" : " --printer " + Shown(printer));
  return MakeError(
      absl::StatusCode::kNotFound, Reason::kProfileNotFound,
      fmt::format("there is no {} preset {}{}{}", KindName(kind), Shown(name),
                  any ? "" : " for " + Shown(printer),
                  nearest.empty() ? list : fmt::format("; do you mean {}?", Shown(nearest))),
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

/// Preset that a chosen one should be like.
struct Model {
  std::string alias;
  std::string_view key;  ///< setting that should be equal, if no preset has the alias
  std::string value;
};

/// Returns true if both are the same number, or the same text.
bool SameValue(std::string_view a, std::string_view b) {
  constexpr double kSame = 0.0005;  // difference of layer heights, in mm
  const auto first = ToNumber(a);
  const auto second = ToNumber(b);
  if (first && second) return std::abs(*first - *second) < kSame;
  return a == b;
}

/// Chooses processes and filaments for one printer.
class Chooser {
 public:
  Chooser(const PresetSet& set, const Preset& printer, const PrinterFit& fit)
      : set_(set), printer_(printer), fit_(fit) {}

  /// Returns the preset of this name.
  absl::StatusOr<const Preset*> Choose(PresetKind kind, const std::string& name) const {
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
    return UnknownName(kind, name, known, printer_.name);
  }

  /// Returns the preset that is most like `model`. `process`: process that a filament must fit, or
  /// nullptr. Adds a note if neither `model` nor a default of the printer decides.
  absl::StatusOr<const Preset*> Default(PresetKind kind, Model model, const Preset* process,
                                        std::vector<std::string>& notes) const {
    const Preset* usual = UsualOf(kind);
    if (usual != nullptr && process != nullptr && !AcceptsProcess(set_, *usual, *process))
      usual = nullptr;
    if (usual != nullptr && model.alias.empty() && model.value.empty()) return usual;
    const bool stand_in = usual == nullptr && kind == PresetKind::kFilament && model.value.empty();
    if (stand_in) model.value = "PLA";
    const Preset* best = nullptr;
    int quality = 0;
    for (const Preset* preset : MadeFor(set_, fit_, kind)) {
      const int own = QualityOf(*preset, model, usual);
      if (own <= quality) continue;
      if (process != nullptr && !AcceptsProcess(set_, *preset, *process)) continue;
      best = preset;
      quality = own;
    }
    if (best == nullptr) return NoneFits(kind);
    const bool decided = !stand_in && quality >= kSameKey;
    if (usual == nullptr && !decided) {
      notes.push_back(fmt::format(
          "the default {} preset of {} is missing or not made for this printer; {} is used instead",
          KindName(kind), Shown(printer_.name), Shown(best->name)));
    }
    return best;
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
    return Unfit(fmt::format("several presets for {} have the name {}: choose one of {}",
                             Shown(printer_.name), Shown(name), ShownNames(presets)));
  }

  absl::Status NotMadeFor(const Preset& preset, const std::vector<const Preset*>& all) const {
    if (const auto lineage = set_.Lineage(preset); !lineage.ok()) return lineage.status();
    return Unfit(
        fmt::format("the {} preset {} is not made for {}; the presets for this printer are {}",
                    KindName(preset.kind), Shown(preset.name), Shown(printer_.name),
                    all.empty() ? "none of the given presets" : ShownNames(all)));
  }

  /// Ranks of presets as in OrcaSlicer and PrusaSlicer: the alias decides, then an equal setting,
  /// then the printer's default.
  static constexpr int kSameAlias = 1000, kSameKey = 10;

  int QualityOf(const Preset& preset, const Model& model, const Preset* usual) const {
    const int own = preset.scope == printer_.scope ? 1 : 0;
    if (!model.alias.empty() && preset.alias == model.alias) return kSameAlias + own;
    const int quality = &preset == usual ? 2 : 1;
    if (model.value.empty()) return quality;
    const auto lineage = set_.Lineage(preset);
    if (!lineage.ok()) return quality;
    const std::string text(PresetSet::ValueOf(*lineage, model.key));
    const std::vector<std::string> items = ListItems(text);
    const bool same = SameValue(items.empty() ? text : items.front(), model.value);
    return same ? quality * kSameKey : quality;
  }

  absl::Status NoneFits(PresetKind kind) const {
    return MakeError(absl::StatusCode::kNotFound, Reason::kProfileNotFound,
                     fmt::format("none of the given {} presets is made for {}", KindName(kind),
                                 Shown(printer_.name)),
                     {{"kind", std::string(KindName(kind))}});
  }

  /// Returns the printer's default, or nullptr. Vendors often name the preset of another printer,
  /// so that the one with the same alias is meant.
  const Preset* UsualOf(PresetKind kind) const {
    for (const std::string& name : DefaultNames(kind))
      for (const std::string& each : {name, AliasOf(name)})
        if (const auto chosen = Choose(kind, each); chosen.ok()) return *chosen;
    return nullptr;
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

absl::StatusOr<std::vector<const Preset*>> ListedPresets(const PresetSet& set,
                                                         std::string_view printer) {
  std::vector<const Preset*> listed;
  if (printer.empty()) {
    for (const Preset& preset : set.presets())
      if (preset.listed) listed.push_back(&preset);
  } else {
    const auto printers = PrintersNamed(set, printer);
    if (!printers.ok()) return printers.status();
    for (const Preset* each : *printers) {
      const auto fit = PrinterFit::Make(set, *each);
      if (!fit.ok()) return fit.status();
      listed.push_back(each);
      for (const PresetKind kind : {PresetKind::kProcess, PresetKind::kFilament})
        for (const Preset* made : MadeFor(set, *fit, kind)) listed.push_back(made);
    }
  }
  // A preset's address gives its place in the set, and so an order that is always the same.
  std::ranges::sort(listed, {}, [](const Preset* each) {
    return std::tuple(each->kind, each->name, each->scope, each);
  });
  listed.erase(std::unique(listed.begin(), listed.end()), listed.end());
  return listed;
}

absl::StatusOr<ChosenPresets> ChoosePresets(const PresetSet& set, const PresetNames& names,
                                            const FormerPresets& former) {
  ChosenPresets chosen;
  const auto printer = ChoosePrinter(set, names.printer);
  if (!printer.ok()) return printer.status();
  chosen.printer = *printer;
  const auto fit = PrinterFit::Make(set, *chosen.printer);
  if (!fit.ok()) return fit.status();
  const Chooser chooser(set, *chosen.printer, *fit);
  const auto choose = [&](PresetKind kind, const std::string& name, const Model& model) {
    return name.empty() ? chooser.Default(kind, model, chosen.process, chosen.notes)
                        : chooser.Choose(kind, name);
  };
  const auto process = choose(PresetKind::kProcess, names.process,
                              {former.process_alias, "layer_height", former.layer_height});
  if (!process.ok()) return process.status();
  chosen.process = *process;
  const auto filament = choose(PresetKind::kFilament, names.filament,
                               {former.filament_alias, "filament_type", former.filament_type});
  if (!filament.ok()) return filament.status();
  chosen.filament = *filament;
  if (!AcceptsProcess(set, *chosen.filament, *chosen.process))
    return Unfit(fmt::format("the filament preset {} is not made for the process {}",
                             Shown(chosen.filament->name), Shown(chosen.process->name)));
  return chosen;
}

}  // namespace slicefarm::config::presets
