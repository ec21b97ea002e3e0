#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/console/model_file.h"
#include "services/cli/models/given_models.h"
#include "services/cli/models/project_json.h"

namespace slicefarm::cli {
namespace {

ExitCode Inspect(const std::string& path) {
  const auto file = ReadModelFile(path);
  if (!file.ok()) return Fail(file.status());
  const auto project = ReadProject(path, *file);
  if (!project.ok()) return Fail(project.status());
  Print(ProjectJson(*project));
  return ExitCode::kOk;
}

}  // namespace

void AddInspect(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "inspect", "Print the objects, parts, positions, plates and settings of a project as JSON");
  const auto path = std::make_shared<std::string>();
  command->add_option("MODEL", *path, "3MF project or other model file")->required();
  command->footer(
      "All settings have PrusaSlicer's names, also in projects of OrcaSlicer and Bambu "
      "Studio;\nsettings without a counterpart are listed as without_effect.\nExample:\n  "
      "slicefarm inspect plate.3mf | jq '.objects[].name'");
  command->callback([path, &context] { context.run = [path] { return Inspect(*path); }; });
}

}  // namespace slicefarm::cli
