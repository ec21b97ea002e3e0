#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/revision_ref.h"
#include "common/wire/options/given_settings_wire.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/json_text.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

struct ProfileOptions {
  ServerOptions server;
  SettingOptions settings;
  std::string name;
  int64_t revision = 0;
  bool json = false;
};

/// Splits `NAME@REVISION`, the form that `put` prints, into a name and --revision.
absl::Status TakeRevision(ProfileOptions& options) {
  auto of = ParseRevisionRef(options.name);
  if (!of.ok()) return of.status();
  if (of->revision == 0) return absl::OkStatus();
  if (options.revision > 0 && options.revision != of->revision)
    return Malformed(fmt::format("{} and --revision {} name two different revisions", options.name,
                                 options.revision));
  options.name = std::move(of->name);
  options.revision = of->revision;
  return absl::OkStatus();
}

ExitCode Put(ProfileOptions options, Interrupt& interrupt) {
  const auto settings = GivenSettings(options.settings);
  if (!settings.ok()) return Fail(settings.status());
  v1::PutProfileRequest request;
  request.set_name(options.name);
  SettingsToProto(*settings, request.mutable_settings());
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto profile = client.PutProfile(request);
  if (!profile.ok()) return Fail(profile.status());
  Print(fmt::format("{}@{}\n", profile->name(), profile->revision()));
  return ExitCode::kOk;
}

ExitCode GetProfile(ProfileOptions options, Interrupt& interrupt) {
  if (absl::Status ok = TakeRevision(options); !ok.ok()) return Fail(ok);
  v1::GetProfileRequest request;
  request.set_name(options.name);
  request.set_revision(options.revision);
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto profile = client.GetProfile(request);
  if (!profile.ok()) return Fail(profile.status());
  if (options.json) {
    Print(JsonLine(*profile) + "\n");
    return ExitCode::kOk;
  }
  std::string text = fmt::format("# {}@{}\n", profile->name(), profile->revision());
  for (const v1::Setting& setting : profile->settings())
    text += fmt::format("{} = {}\n", setting.key(), setting.value());
  Print(text);
  return ExitCode::kOk;
}

ExitCode ListProfiles(ProfileOptions options, Interrupt& interrupt) {
  using google::protobuf::util::TimeUtil;
  JobsClient client(ClientOptions(options.server, &interrupt));
  std::string text = fmt::format("{:<40}  {:>8}  {}\n", "PROFILE", "REVISION", "CREATED");
  if (options.json) text.clear();
  v1::ListProfilesRequest request;
  do {
    const auto page = client.ListProfiles(request);
    if (!page.ok()) return Fail(page.status());
    for (const v1::Profile& profile : page->profiles()) {
      if (options.json) {
        text += JsonLine(profile) + "\n";
        continue;
      }
      google::protobuf::Timestamp created = profile.create_time();
      created.set_nanos(0);
      text += fmt::format("{:<40}  {:>8}  {}\n", profile.name(), profile.revision(),
                          TimeUtil::ToString(created));
    }
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  Print(text);
  return ExitCode::kOk;
}

ExitCode DeleteProfile(ProfileOptions options, Interrupt& interrupt) {
  if (absl::Status ok = TakeRevision(options); !ok.ok()) return Fail(ok);
  v1::DeleteProfileRequest request;
  request.set_name(options.name);
  request.set_revision(options.revision);
  JobsClient client(ClientOptions(options.server, &interrupt));
  const absl::Status deleted = client.DeleteProfile(request);
  return deleted.ok() ? ExitCode::kOk : Fail(deleted);
}

CLI::App* AddTo(CLI::App& parent, const char* name, const char* about,
                const std::shared_ptr<ProfileOptions>& options, CommandContext& context,
                ExitCode (*run)(ProfileOptions, Interrupt&)) {
  CLI::App* command = parent.add_subcommand(name, about);
  AddServerOptions(*command, options->server);
  command->callback([options, &context, run] {
    context.run = [options, &context, run] { return run(*options, *context.interrupt); };
  });
  return command;
}

}  // namespace

void AddProfile(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("profile", "Manage settings that the farm stores under a name");
  command->require_subcommand(1);
  const auto options = std::make_shared<ProfileOptions>();
  CLI::App* put = AddTo(*command, "put",
                        "Store settings as a new revision of a profile, and print NAME@REVISION",
                        options, context, Put);
  put->add_option("NAME", options->name, "Name of the profile: letters, digits, -, _ and .")
      ->required();
  AddSettingOptions(*put, options->settings);
  CLI::App* get = AddTo(*command, "get", "Print the settings of a profile as a config.ini", options,
                        context, GetProfile);
  get->add_option("NAME", options->name, "Name of the profile, or NAME@REVISION")->required();
  get->add_flag("--json", options->json, "Print the revision as JSON");
  get->add_option("--revision", options->revision, "Revision to print; default: the newest")
      ->check(AboveZero())
      ->type_name("N");
  CLI::App* remove = AddTo(*command, "delete",
                           "Remove a profile; jobs that were made with the profile do not change",
                           options, context, DeleteProfile);
  remove->add_option("NAME", options->name, "Name of the profile, or NAME@REVISION")->required();
  remove->add_option("--revision", options->revision, "Revision to remove; default: all")
      ->check(AboveZero())
      ->type_name("N");
  AddTo(*command, "list", "List all profiles with their newest revisions", options, context,
        ListProfiles)
      ->add_flag("--json", options->json, "Print each profile as one line of JSON");
  command->footer(
      "Revisions never change; each job records the revision of the profile that it "
      "used.\nExamples:\n  slicefarm profile put mk4-pla --config prusa.ini\n  slicefarm submit "
      "part.stl -o part.gcode --profile mk4-pla --set fill_density=30%");
}

}  // namespace slicefarm::cli
