#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/job_presets.h"
#include "common/config/table/suggest.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/console/exit_code.h"
#include "services/cli/farm/farm_presets.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/job/job_options.h"
#include "services/cli/models/preset_sources.h"

namespace slicefarm::cli {
namespace {

using config::presets::Preset;
using config::presets::PresetKind;
using config::presets::PresetSet;

struct PresetsOptions {
  ServerOptions server;
  std::vector<std::string> sources;  ///< empty: the presets of the farm
  std::vector<std::string> bundles;
  std::string printer, process, filament;
  std::string name;
  bool json = false;
};

std::string_view DialectName(config::presets::PresetDialect dialect) {
  switch (dialect) {
    case config::presets::PresetDialect::kOrca:
      return "orca";
    case config::presets::PresetDialect::kPrusa:
      return "prusa";
    case config::presets::PresetDialect::kSuper:
      return "super";
  }
  return "";
}

absl::StatusOr<PresetSet> ReadPresetsOf(const PresetsOptions& options, Interrupt& interrupt) {
  if (!options.sources.empty()) return ReadPresetSources(options.sources);
  JobsClient client(ClientOptions(options.server, &interrupt));
  return FetchPresets(options.bundles, client);
}

nlohmann::ordered_json PresetJson(const PresetSet& set, const Preset& preset) {
  return {{"kind", std::string(KindName(preset.kind))},
          {"name", preset.name},
          {"vendor", set.ScopeOf(preset).vendor},
          {"dialect", std::string(DialectName(preset.dialect))},
          {"file", preset.file}};
}

ExitCode ListPresets(const PresetsOptions& options, Interrupt& interrupt) {
  const auto set = ReadPresetsOf(options, interrupt);
  if (!set.ok()) return Fail(set.status());
  Warn(set->problems());
  const auto listed = config::presets::ListedPresets(*set, options.printer);
  if (!listed.ok()) return Fail(listed.status());
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string text;
  for (const Preset* preset : *listed) {
    if (options.json) json.push_back(PresetJson(*set, *preset));
    const std::string& vendor = set->ScopeOf(*preset).vendor;
    text += fmt::format("{:<9} {}{}\n", KindName(preset->kind), ReplaceControls(preset->name, '?'),
                        vendor.empty() ? "" : fmt::format("  ({})", ReplaceControls(vendor, '?')));
  }
  Print(options.json ? json.dump(2) + "\n" : text);
  return ExitCode::kOk;
}

/// Returns the presets of this name, of any kind.
absl::StatusOr<std::vector<const Preset*>> PresetsNamed(const PresetSet& set,
                                                        const std::string& name) {
  std::vector<const Preset*> found;
  for (const PresetKind kind : {PresetKind::kPrinter, PresetKind::kProcess, PresetKind::kFilament})
    for (const Preset* preset : set.Named(kind, name)) found.push_back(preset);
  if (!found.empty()) return found;
  std::vector<std::string_view> known;
  std::string nearest;
  for (const Preset& preset : set.presets()) {
    if (!preset.listed) continue;
    known.push_back(preset.name);
    if (nearest.empty() && preset.name.starts_with(name + " @")) nearest = preset.name;
  }
  if (nearest.empty()) nearest = config::Nearest(name, known);
  return MakeError(absl::StatusCode::kNotFound, Reason::kProfileNotFound,
                   fmt::format("there is no preset \"{}\"{}", ReplaceControls(name, '?'),
                               nearest.empty() ? "; `slicefarm presets list` shows the names"
                                               : fmt::format("; do you mean \"{}\"?", nearest)));
}

/// Prints the settings of a job with these presets, in the names of their program.
ExitCode ShowJob(const PresetSet& set, const PresetsOptions& options) {
  const auto chosen = ChoosePresets(set, {options.printer, options.process, options.filament});
  if (!chosen.ok()) return Fail(chosen.status());
  const auto values = CombinePresets(set, *chosen);
  if (!values.ok()) return Fail(values.status());
  Warn(chosen->notes);
  nlohmann::ordered_json json;
  for (const Preset* preset : {chosen->printer, chosen->process, chosen->filament})
    json[std::string(KindName(preset->kind))] = PresetJson(set, *preset);
  std::string text = fmt::format("# printer \"{}\", process \"{}\", filament \"{}\"\n",
                                 ReplaceControls(chosen->printer->name, '?'),
                                 ReplaceControls(chosen->process->name, '?'),
                                 ReplaceControls(chosen->filament->name, '?'));
  for (const config::presets::SourcedValue& each : *values) {
    const std::string source = each.from == nullptr ? "default" : each.from->name;
    json["settings"][each.key] = {{"value", each.value}, {"preset", source}};
    if (each.from != nullptr) json["settings"][each.key]["file"] = each.from->file;
    text += fmt::format("{} = {}  # {}\n", ReplaceControls(each.key, '?'),
                        ReplaceControls(each.value, '?'), ReplaceControls(source, '?'));
  }
  Print(options.json ? json.dump(2) + "\n" : text);
  return ExitCode::kOk;
}

ExitCode ShowPreset(const PresetsOptions& options, Interrupt& interrupt) {
  const auto set = ReadPresetsOf(options, interrupt);
  if (!set.ok()) return Fail(set.status());
  if (options.name.empty() && options.printer.empty())
    return Fail(Malformed("the name of a preset, or --printer, is needed"));
  if (options.name.empty()) return ShowJob(*set, options);
  const auto found = PresetsNamed(*set, options.name);
  if (!found.ok()) return Fail(found.status());
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string text;
  for (const Preset* preset : *found) {
    const auto flat = set->Flatten(*preset);
    if (!flat.ok()) return Fail(flat.status());
    nlohmann::ordered_json one = PresetJson(*set, *preset);
    text += fmt::format("# {} \"{}\" of {}\n", KindName(preset->kind),
                        ReplaceControls(preset->name, '?'), preset->file);
    for (const auto& [key, value] : *flat) {
      one["settings"][key] = {
          {"value", value.value}, {"preset", value.from->name}, {"file", value.from->file}};
      text +=
          fmt::format("{} = {}  # {}\n", ReplaceControls(key, '?'),
                      ReplaceControls(value.value, '?'), ReplaceControls(value.from->name, '?'));
    }
    if (options.json) json.push_back(std::move(one));
  }
  Print(options.json ? json.dump(2) + "\n" : text);
  return ExitCode::kOk;
}

CLI::App* AddPresetCommand(CLI::App& parent, const char* name, const char* about,
                           const std::shared_ptr<PresetsOptions>& options, CommandContext& context,
                           ExitCode (*run)(const PresetsOptions&, Interrupt&)) {
  CLI::App* command = parent.add_subcommand(name, about);
  CLI::Option* sources = AddPresetSources(*command, options->sources);
  command
      ->add_option("--bundle", options->bundles,
                   "Bundle of presets on the farm to use, without --presets; default: all bundles. "
                   "May be repeated")
      ->excludes(sources)
      ->type_name("NAME[@REVISION]")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print JSON");
  AddServerOptions(*command, options->server);
  command->callback([options, &context, run] {
    context.run = [options, &context, run] { return run(*options, *context.interrupt); };
  });
  return command;
}

}  // namespace

void AddPresets(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "presets", "List and show presets of other slicers, by name, and store them on a farm");
  command->require_subcommand(1);
  const auto options = std::make_shared<PresetsOptions>();
  AddPresetCommand(*command, "list", "List the presets that a job may name", options, context,
                   ListPresets)
      ->add_option("--printer", options->printer,
                   "Printer or printer model: list only this printer, or the printers of this "
                   "model, and the presets that are made for them")
      ->type_name("NAME");
  CLI::App* show = AddPresetCommand(*command, "show",
                                    "Print all settings of a preset, or of a job for --printer, "
                                    "with the preset that defines each setting",
                                    options, context, ShowPreset);
  CLI::Option* name =
      show->add_option("NAME", options->name, "Name of a printer, process or filament preset");
  CLI::Option* printer =
      show->add_option("--printer", options->printer, "Printer preset of the job to show")
          ->type_name("NAME");
  printer->excludes(name);
  for (const auto& [option, value] :
       {std::pair("--process", &options->process), std::pair("--filament", &options->filament)})
    show->add_option(option, *value,
                     "Preset of the job; default: the preset that the printer preset names")
        ->needs(printer)
        ->type_name("NAME");
  AddFarmPresets(*command, context);
  command->footer(
      "Without --presets, the commands are about the presets that the farm stores.\n"
      "Examples:\n"
      "  slicefarm presets list --presets ~/.config/OrcaSlicer --printer \"Prusa MK4\"\n"
      "  slicefarm presets import ~/.config/OrcaSlicer/system --server farm:50050\n"
      "  slicefarm presets show \"0.20mm SPEED @MK4S 0.4\" --presets PrusaResearch.ini\n"
      "  slicefarm slice part.stl -o part.gcode --presets ~/.config/OrcaSlicer \\\n"
      "    --printer \"Prusa MK4 0.4 nozzle\" --process \"0.20mm Standard\" --filament \"Prusa "
      "Generic PLA\"");
}

}  // namespace slicefarm::cli
