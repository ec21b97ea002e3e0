#pragma once

#include "services/cli/console/command_context.h"

namespace CLI {
class App;
}

namespace slicefarm::lab {

/// Each function of this file adds a subcommand to `app`. `app` and `context` must outlive the
/// parsing and the run of the command.
void AddBeads(CLI::App& app, cli::CommandContext& context);  ///< defined in beads_command.cc
void AddFill(CLI::App& app, cli::CommandContext& context);   ///< defined in fill_command.cc
void AddDecompose(CLI::App& app,
                  cli::CommandContext& context);               ///< defined in decompose_command.cc
void AddTsp(CLI::App& app, cli::CommandContext& context);      ///< defined in tsp_command.cc
void AddFlatten(CLI::App& app, cli::CommandContext& context);  ///< defined in flatten_command.cc
void AddWaterline(CLI::App& app,
                  cli::CommandContext& context);  ///< defined in waterline_command.cc
void AddSupportLab(CLI::App& app,
                   cli::CommandContext& context);  ///< defined in support_lab_command.cc

}  // namespace slicefarm::lab
