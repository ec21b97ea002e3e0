#pragma once

#include "services/cli/console/command_context.h"

namespace CLI {
class App;
}

namespace slicefarm::lab {

/// Functions that each add a subcommand. `app` and `context` must outlive the parsing and the run.
void AddBeads(CLI::App& app, cli::CommandContext& context);       ///< beads_command.cc
void AddFill(CLI::App& app, cli::CommandContext& context);        ///< fill_command.cc
void AddDecompose(CLI::App& app, cli::CommandContext& context);   ///< decompose_command.cc
void AddTsp(CLI::App& app, cli::CommandContext& context);         ///< tsp_command.cc
void AddFlatten(CLI::App& app, cli::CommandContext& context);     ///< flatten_command.cc
void AddWaterline(CLI::App& app, cli::CommandContext& context);   ///< waterline_command.cc
void AddSupportLab(CLI::App& app, cli::CommandContext& context);  ///< support_lab_command.cc

}  // namespace slicefarm::lab
