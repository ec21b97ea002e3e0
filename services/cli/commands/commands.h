#pragma once

#include "services/cli/console/command_context.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Each function of this file adds its subcommand. `app` and `context` must outlive the parsing and
/// the run of the command.
void AddSlice(CLI::App& app, CommandContext& context);      ///< defined in slice_command.cc
void AddCalibrate(CLI::App& app, CommandContext& context);  ///< defined in calibrate_command.cc
void AddSubmit(CLI::App& app, CommandContext& context);     ///< defined in submit_command.cc
void AddInspect(CLI::App& app, CommandContext& context);    ///< defined in inspect_command.cc
/// Defined in job_commands.cc, like the next six.
void AddWatch(CLI::App& app, CommandContext& context);
void AddList(CLI::App& app, CommandContext& context);
void AddGet(CLI::App& app, CommandContext& context);
void AddCancel(CLI::App& app, CommandContext& context);
void AddDelete(CLI::App& app, CommandContext& context);
void AddTrace(CLI::App& app, CommandContext& context);
void AddWebhook(CLI::App& app, CommandContext& context);
/// Defined in farm_commands.cc, like the next five.
void AddEvents(CLI::App& app, CommandContext& context);
void AddArtifacts(CLI::App& app, CommandContext& context);
void AddUsage(CLI::App& app, CommandContext& context);
void AddCaller(CLI::App& app, CommandContext& context);
void AddMeshes(CLI::App& app, CommandContext& context);
void AddUpdate(CLI::App& app, CommandContext& context);
void AddTime(CLI::App& app, CommandContext& context);     ///< defined in time_command.cc
void AddCheck(CLI::App& app, CommandContext& context);    ///< defined in check_command.cc
void AddProfile(CLI::App& app, CommandContext& context);  ///< defined in profile_command.cc
void AddPresets(CLI::App& app, CommandContext& context);  ///< defined in presets_command.cc
/// Adds subcommands to `presets`; defined in farm_presets_commands.cc.
void AddFarmPresets(CLI::App& presets, CommandContext& context);
/// Adds `apply` to `calibrate`; defined in apply_command.cc.
void AddApply(CLI::App& calibrate, CommandContext& context);
void AddRender(CLI::App& app, CommandContext& context);      ///< defined in render_command.cc
void AddSettings(CLI::App& app, CommandContext& context);    ///< defined in settings_command.cc
void AddHealth(CLI::App& app, CommandContext& context);      ///< defined in health_command.cc
void AddTenant(CLI::App& app, CommandContext& context);      ///< defined in tenant_command.cc
void AddToken(CLI::App& app, CommandContext& context);       ///< defined in token_command.cc
void AddHelp(CLI::App& app, CommandContext& context);        ///< defined in shell_commands.cc
void AddCompletion(CLI::App& app, CommandContext& context);  ///< defined in shell_commands.cc
void AddVersion(CLI::App& app, CommandContext& context);     ///< defined in cli_program.cc

}  // namespace slicefarm::cli
