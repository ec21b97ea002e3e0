#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "services/cli/commands/commands.h"
#include "services/cli/commands/gcode_options.h"
#include "services/cli/console/console.h"
#include "services/motion/algo/program/program_time.h"

namespace slicefarm::cli {
namespace {

struct TimeOptions : GcodeOptions {
  bool json = false;
};

/// Joins a feature's words to one word.
std::string AsKey(std::string words) {
  std::ranges::replace_if(
      words, [](char c) { return c == ' ' || c == '\t'; }, '_');
  return words;
}

std::string ToText(const motion::ProgramTime& time, const GcodeFile& file) {
  std::string text = fmt::format(
      "flavor {}\nconfig {}\ntime_s {:.6f}\nmove_s {:.6f}\ndwell_s {:.6f}\ntravel_s {:.6f}\n"
      "retract_s {:.6f}\nheating_s {:.6f}\n",
      file.firmware->name(), file.machine.source, time.TotalS(), time.move_s, time.dwell_s,
      time.travel_s, time.retract_s, time.heating_s);
  for (const auto& [feature, seconds] : time.feature_s)
    text += fmt::format("feature_{}_s {:.6f}\n", AsKey(feature), seconds);
  text += fmt::format(
      "moves {}\nhomings {}\nheat_waits {}\ntool_changes {}\nlayers {}\n"
      "before_layers_s {:.6f}\n",
      time.moves, time.homings, time.heat_waits, time.tool_changes, time.layer_s.size(),
      time.before_s);
  for (size_t i = 0; i < time.layer_s.size(); ++i)
    text += fmt::format("layer_{}_s {:.6f}\n", i, time.layer_s[i]);
  return text;
}

std::string ToJson(const motion::ProgramTime& time, const GcodeFile& file) {
  const nlohmann::ordered_json json = {{"flavor", std::string(file.firmware->name())},
                                       {"config", file.machine.source},
                                       {"time_s", time.TotalS()},
                                       {"move_s", time.move_s},
                                       {"dwell_s", time.dwell_s},
                                       {"travel_s", time.travel_s},
                                       {"retract_s", time.retract_s},
                                       {"heating_s", time.heating_s},
                                       {"features_s", time.feature_s},
                                       {"moves", time.moves},
                                       {"homings", time.homings},
                                       {"heat_waits", time.heat_waits},
                                       {"tool_changes", time.tool_changes},
                                       {"before_layers_s", time.before_s},
                                       {"layers_s", time.layer_s}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

ExitCode Time(const TimeOptions& options) {
  const auto file = ReadGcode(options);
  if (!file.ok()) return Fail(file.status());
  const motion::ProgramTime time =
      motion::TimeOfProgram(file->gcode, *file->firmware, file->machine.setup.machine);
  Print(options.json ? ToJson(time, *file) : ToText(time, *file));
  return ExitCode::kOk;
}

}  // namespace

void AddTime(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "time", "Estimate the print time of any G-code file as its firmware plans the moves");
  const auto options = std::make_shared<TimeOptions>();
  AddGcodeOptions(*command, *options);
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Prints rows of `key value`, in seconds. time_s is the sum of move_s, dwell_s (G4) and "
      "heating_s\n(waiting for temperatures, if the settings have nozzle_heating_rate or "
      "bed_heating_rate).\nmove_s is the sum of travel_s, retract_s (filament only) and the "
      "feature_NAME_s of the features\nthat the slicer's comments name. layer_N_s and "
      "before_layers_s add up to time_s as well.\nEvents of unknown duration take 0 s and are "
      "counted: homings, heat_waits, tool_changes.\nExample:\n  slicefarm time part.gcode --flavor "
      "klipper --config printer.cfg");
  command->callback([options, &context] { context.run = [options] { return Time(*options); }; });
}

}  // namespace slicefarm::cli
