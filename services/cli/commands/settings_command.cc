#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "common/base/error.h"
#include "common/config/coverage.h"
#include "common/config/table/settings_table.h"
#include "common/config/table/suggest.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

struct SettingsOptions {
  std::string pattern;
  std::string coverage;
  Process process = kDefaultProcess;
  bool json = false;
  bool ini = false;
};

/// Returns the narrowest scope in which a setting can be set.
std::string_view PlaceOf(const config::SettingSpec& spec) {
  std::string_view place = config::ScopeName(spec.scope());
  return place.substr(place.find(' ') + 1);
}

nlohmann::ordered_json ToJson(const config::SettingSpec& spec) {
  nlohmann::ordered_json json = {
      {"key", std::string(spec.key)},         {"kind", std::string(config::KindName(spec.kind))},
      {"group", std::string(spec.group)},     {"default", std::string(spec.standard)},
      {"range", config::DescribeRange(spec)}, {"unit", std::string(spec.unit)},
      {"scope", std::string(PlaceOf(spec))},  {"doc", std::string(spec.doc)}};
  if (spec.min < spec.max) {
    json["min"] = spec.min;
    json["max"] = spec.max;
  }
  for (const config::Choice& choice : spec.choices)
    if (choice.note.empty()) json["choices"].push_back(std::string(choice.name));
  for (const config::Need* need : spec.needs) json["needs"].push_back(std::string(need->what));
  return json;
}

std::string ToText(const config::SettingSpec& spec) {
  return fmt::format("{} = {}\n    {}.\n    {}{}{}\n", spec.key, spec.standard, spec.doc,
                     config::DescribeRange(spec), spec.unit.empty() ? "" : "; unit: ", spec.unit);
}

std::string ToIni(const config::SettingSpec& spec) {
  return fmt::format("# {}. {}{}{}\n{} = {}\n", spec.doc, config::DescribeRange(spec),
                     spec.unit.empty() ? "" : "; unit: ", spec.unit, spec.key, spec.standard);
}

ExitCode ListCoverage(const std::string& path) {
  SettingOptions given;
  given.config_files = {path};
  const auto settings = GivenSettings(given);
  if (!settings.ok()) return Fail(settings.status());
  const config::Coverage coverage = config::CoverageOf(*settings);
  std::string text = fmt::format("keys {} effect {} partial {} none {}\n", coverage.keys,
                                 coverage.effect, coverage.partial, coverage.none);
  for (const std::string& line : coverage.without) text += line + "\n";
  Print(text);
  return ExitCode::kOk;
}

struct Listed {
  std::string text;
  nlohmann::ordered_json json = nlohmann::ordered_json::array();

  bool empty() const { return text.empty() && json.empty(); }
};

void List(const SettingsOptions& options, Process process, Listed& listed) {
  for (const config::SettingSpec& spec : config::SettingsTable(process)) {
    if (spec.key.find(options.pattern) == std::string_view::npos) continue;
    if (options.json) {
      listed.json.push_back(ToJson(spec));
    } else {
      listed.text += options.ini ? ToIni(spec) : ToText(spec);
    }
  }
}

/// Finds the setting in another process if the default process does not have it.
Listed ListedElsewhere(const SettingsOptions& options) {
  Listed listed;
  for (const ProcessInfo& info : kProcesses) {
    List(options, info.process, listed);
    if (listed.empty()) continue;
    fmt::print(stderr, "of --machine {}:\n", info.name);
    break;
  }
  return listed;
}

ExitCode ListSettings(const SettingsOptions& options) {
  if (!options.coverage.empty()) return ListCoverage(options.coverage);
  Listed listed;
  List(options, options.process, listed);
  if (listed.empty() && options.process == kDefaultProcess) listed = ListedElsewhere(options);
  if (listed.empty()) {
    const std::string nearest = config::NearestSetting(options.pattern, options.process);
    return Fail(
        MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingUnknown,
                  fmt::format("no setting has '{}' in its name{}", options.pattern,
                              nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest))));
  }
  Print(options.json ? listed.json.dump(2) + "\n" : listed.text);
  return ExitCode::kOk;
}

}  // namespace

void AddSettings(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("settings", "List every setting with its range, default and meaning");
  const auto options = std::make_shared<SettingsOptions>();
  command->add_option(
      "PATTERN", options->pattern,
      "Part of a name: list only settings with this part in their names; default: all settings");
  AddMachineOption(*command, options->process);
  CLI::Option* json = command->add_flag("--json", options->json, "Print the settings as JSON");
  command->add_flag("--ini", options->ini, "Print a config.ini with the defaults and comments")
      ->excludes(json);
  command
      ->add_option("--coverage", options->coverage,
                   "PrusaSlicer config.ini to check: print how many of its settings have an effect "
                   "in slicefarm, and the settings without effect")
      ->type_name("PROFILE.ini");
  command->footer(
      "Names and meanings are the same as in PrusaSlicer's config.ini.\nExample:\n  slicefarm "
      "settings speed");
  command->callback(
      [options, &context] { context.run = [options] { return ListSettings(*options); }; });
}

}  // namespace slicefarm::cli
