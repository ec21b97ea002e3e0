#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "common/config/presets/overlay_names.h"
#include "common/wire/calibration_wire.h"
#include "common/wire/options/given_settings_wire.h"
#include "services/cli/calibration/calibration_kind.h"
#include "services/cli/calibration/chosen_value.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

struct ApplyOptions {
  ServerOptions server;
  std::string job;
  std::string value;
  std::string profile;
  bool all_filaments = false;
};

/// Returns the profile that gets the value.
absl::StatusOr<std::string> ProfileFor(const ApplyOptions& options, const v1::JobSpec& spec) {
  if (!options.profile.empty()) return options.profile;
  const v1::JobPresets& presets = spec.presets();
  if (presets.printer().empty())
    return Malformed(
        "the job names no printer preset of the farm: name the profile that gets the value with "
        "--profile NAME");
  const CalibrationInfo* info = CalibrationNamed(spec.calibration().kind());
  const bool of_filament = info != nullptr && info->of_filament && !options.all_filaments;
  return config::presets::OverlayName(presets.printer(), of_filament ? presets.filament() : "");
}

/// Returns the newest revision of a profile; a profile without settings and with revision 0 if
/// there is none.
absl::StatusOr<v1::Profile> NewestOf(const std::string& name, JobsClient& client) {
  v1::GetProfileRequest get;
  get.set_name(name);
  auto profile = client.GetProfile(get);
  if (absl::IsNotFound(profile.status())) return v1::Profile();
  return profile;
}

/// Stores settings in a profile. Its other settings stay. If another call changes the profile at
/// the same time, reads the profile again.
absl::StatusOr<v1::Profile> StoreIn(const std::string& name, const std::vector<Setting>& chosen,
                                    JobsClient& client) {
  while (true) {
    const auto newest = NewestOf(name, client);
    if (!newest.ok()) return newest.status();
    std::vector<Setting> settings = SettingsFromProto(newest->settings());
    for (const Setting& each : chosen) {
      std::erase_if(settings, [&](const Setting& old) { return old.key == each.key; });
      settings.push_back(each);
    }
    v1::PutProfileRequest put;
    put.set_name(name);
    put.set_base_revision(newest->revision());
    SettingsToProto(settings, put.mutable_settings());
    auto stored = client.PutProfile(put);
    if (!absl::IsAborted(stored.status())) return stored;
  }
}

/// Stores the chosen value in its profile. Returns the text to print.
absl::StatusOr<std::string> ApplyChosen(const ApplyOptions& options, JobsClient& client) {
  const auto id = client.FullId(options.job);
  if (!id.ok()) return id.status();
  const auto job = client.GetJob(*id);
  if (!job.ok()) return job.status();
  const auto chosen = ChosenSettings(FromProto(job->spec().calibration()), options.value);
  if (!chosen.ok()) return chosen.status();
  const auto name = ProfileFor(options, job->spec());
  if (!name.ok()) return name.status();
  const auto stored = StoreIn(*name, *chosen, client);
  if (!stored.ok()) return stored.status();
  std::string text = fmt::format("{}@{}\n", stored->name(), stored->revision());
  for (const Setting& each : *chosen) text += fmt::format("  {} = {}\n", each.key, each.value);
  return text;
}

}  // namespace

void AddApply(CLI::App& calibrate, CommandContext& context) {
  CLI::App* command = calibrate.add_subcommand(
      "apply", "Store the best value of a calibration print for the next jobs of the farm");
  const auto options = std::make_shared<ApplyOptions>();
  command->add_option("JOB", options->job, "Calibration print of the farm: id, or its beginning")
      ->required();
  command
      ->add_option("VALUE", options->value,
                   "Best value, in the unit of the labels on the print; values between two labels "
                   "are allowed")
      ->required();
  CLI::Option* profile =
      command
          ->add_option("--profile", options->profile,
                       "Profile that gets the value; default: the overlay of the job's printer "
                       "preset, which the farm adds to each job that names this printer")
          ->type_name("NAME");
  command
      ->add_flag("--all-filaments", options->all_filaments,
                 "Use the value for all filaments of the printer; default: values that depend on "
                 "the filament are only for the filament of the print")
      ->excludes(profile);
  AddServerOptions(*command, options->server);
  command->footer(
      "The profile gets a new revision with this setting; its other settings stay.\nExample:\n  "
      "slicefarm calibrate apply 3f2a 0.035 --server farm:50050");
  command->callback([options, &context] {
    context.run = [options, &context] {
      JobsClient client(ClientOptions(options->server, context.interrupt));
      const auto text = ApplyChosen(*options, client);
      if (!text.ok()) return Fail(text.status());
      Print(*text);
      return ExitCode::kOk;
    };
  });
}

}  // namespace slicefarm::cli
