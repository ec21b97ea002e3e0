#pragma once

#include "services/cli/console/command_context.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Each adds its subcommand. `app` and `context` must outlive the parsing and the run.
void AddSlice(CLI::App& app, CommandContext& context);    ///< slice_command.cc
void AddSubmit(CLI::App& app, CommandContext& context);   ///< submit_command.cc
void AddInspect(CLI::App& app, CommandContext& context);  ///< inspect_command.cc
void AddWatch(CLI::App& app, CommandContext& context);    ///< job_commands.cc, as the next five
void AddList(CLI::App& app, CommandContext& context);
void AddGet(CLI::App& app, CommandContext& context);
void AddCancel(CLI::App& app, CommandContext& context);
void AddDelete(CLI::App& app, CommandContext& context);
void AddTrace(CLI::App& app, CommandContext& context);
void AddWebhook(CLI::App& app, CommandContext& context);
void AddEvents(CLI::App& app, CommandContext& context);  ///< farm_commands.cc, as the next five
void AddArtifacts(CLI::App& app, CommandContext& context);
void AddUsage(CLI::App& app, CommandContext& context);
void AddCaller(CLI::App& app, CommandContext& context);
void AddMeshes(CLI::App& app, CommandContext& context);
void AddUpdate(CLI::App& app, CommandContext& context);
void AddTime(CLI::App& app, CommandContext& context);        ///< time_command.cc
void AddCheck(CLI::App& app, CommandContext& context);       ///< check_command.cc
void AddProfile(CLI::App& app, CommandContext& context);     ///< profile_command.cc
void AddRender(CLI::App& app, CommandContext& context);      ///< render_command.cc
void AddSettings(CLI::App& app, CommandContext& context);    ///< settings_command.cc
void AddHealth(CLI::App& app, CommandContext& context);      ///< health_command.cc
void AddTenant(CLI::App& app, CommandContext& context);      ///< tenant_command.cc
void AddToken(CLI::App& app, CommandContext& context);       ///< token_command.cc
void AddHelp(CLI::App& app, CommandContext& context);        ///< shell_commands.cc
void AddCompletion(CLI::App& app, CommandContext& context);  ///< shell_commands.cc
void AddVersion(CLI::App& app, CommandContext& context);     ///< cli_program.cc

}  // namespace slicefarm::cli
