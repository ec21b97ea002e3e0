#pragma once

#include <functional>

#include "services/cli/exit_code.h"
#include "services/cli/interrupt.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// What a command needs besides its options, and where the one that was asked for leaves its work:
/// options are parsed first, then `run` does it.
struct CommandContext {
  Interrupt* interrupt = nullptr;
  std::function<ExitCode()> run;
};

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
void AddBeads(CLI::App& app, CommandContext& context);           ///< beads_command.cc
void AddEngraveProgram(CLI::App& app, CommandContext& context);  ///< engrave_program_command.cc
void AddFlatten(CLI::App& app, CommandContext& context);         ///< flatten_command.cc
void AddFill(CLI::App& app, CommandContext& context);            ///< fill_command.cc
void AddDecompose(CLI::App& app, CommandContext& context);       ///< decompose_command.cc
void AddSupportLab(CLI::App& app, CommandContext& context);      ///< support_lab_command.cc
void AddTime(CLI::App& app, CommandContext& context);            ///< time_command.cc
void AddCheck(CLI::App& app, CommandContext& context);           ///< check_command.cc
void AddProfile(CLI::App& app, CommandContext& context);         ///< profile_command.cc
void AddRender(CLI::App& app, CommandContext& context);          ///< render_command.cc
void AddSettings(CLI::App& app, CommandContext& context);        ///< settings_command.cc
void AddHealth(CLI::App& app, CommandContext& context);          ///< health_command.cc
void AddTenant(CLI::App& app, CommandContext& context);          ///< tenant_command.cc
void AddToken(CLI::App& app, CommandContext& context);           ///< token_command.cc
void AddTsp(CLI::App& app, CommandContext& context);             ///< tsp_command.cc
void AddMillProgram(CLI::App& app, CommandContext& context);     ///< mill_program_command.cc
void AddWaterline(CLI::App& app, CommandContext& context);       ///< waterline_command.cc
void AddHelp(CLI::App& app, CommandContext& context);            ///< shell_commands.cc
void AddCompletion(CLI::App& app, CommandContext& context);      ///< shell_commands.cc
void AddVersion(CLI::App& app, CommandContext& context);         ///< main.cc

}  // namespace slicefarm::cli
