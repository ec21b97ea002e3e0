// Commands that export or erase all data of a tenant on a farm.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "common/base/error.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/server_options.h"

namespace slicefarm::cli {
namespace {

struct TenantOptions {
  ServerOptions server;
  std::string tenant;
  std::string output;
  bool yes = false;
};

ExitCode ExportAll(const TenantOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  auto file = OutputFile::Create(options.output);
  if (!file.ok()) return Fail(file.status());
  absl::Status fetched = client.ExportTenant(options.tenant, *file);
  if (fetched.ok()) fetched = file->Commit();
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

ExitCode EraseAll(const TenantOptions& options, Interrupt& interrupt) {
  if (!options.yes) {
    return Fail(
        MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                  fmt::format("all jobs, meshes, results, profiles and presets of the tenant '{}' "
                              "would be erased: add --yes to confirm",
                              options.tenant)));
  }
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto erased = client.EraseTenant(options.tenant);
  if (!erased.ok()) return Fail(erased.status());
  Print(fmt::format("erased: {} jobs, {} blobs of {} bytes, {} profiles, {} bundles of presets\n",
                    erased->jobs(), erased->blobs(), erased->bytes(), erased->profiles(),
                    erased->preset_bundles()));
  if (erased->shared_blobs() > 0) {
    Print(fmt::format("kept: {} blobs, which jobs of other tenants have as results\n",
                      erased->shared_blobs()));
  }
  return ExitCode::kOk;
}

CLI::App* AddTenantCommand(CLI::App& parent, const char* name, const char* about,
                           const std::shared_ptr<TenantOptions>& options, CommandContext& context,
                           ExitCode (*run)(const TenantOptions&, Interrupt&)) {
  CLI::App* command = parent.add_subcommand(name, about);
  command->add_option("TENANT", options->tenant, "Name of the tenant; '' on a farm without tenants")
      ->required()
      ->type_name("NAME");
  AddServerOptions(*command, options->server);
  command->callback([options, &context, run] {
    context.run = [options, &context, run] { return run(*options, *context.interrupt); };
  });
  return command;
}

}  // namespace

void AddTenant(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("tenant", "Export or erase all data of a tenant");
  command->require_subcommand(1);
  const auto options = std::make_shared<TenantOptions>();
  AddTenantCommand(*command, "export",
                   "Write the jobs, meshes, results and profiles of a tenant to a tar archive",
                   options, context, ExportAll)
      ->add_option("-o,--output", options->output, "File for the archive; -: to stdout")
      ->required()
      ->type_name("FILE");
  CLI::App* erase =
      AddTenantCommand(*command, "erase", "Cancel all jobs of a tenant and erase all its data",
                       options, context, EraseAll);
  erase->add_flag("--yes", options->yes,
                  "Confirm the erasure; nothing is erased without this flag");
  erase->footer(
      "Remove the tenant's entry from the coordinator's --tenants file first, so that no new data "
      "arrives. Backups, logs and the audit trail are not changed.");
}

}  // namespace slicefarm::cli
