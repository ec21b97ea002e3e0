#pragma once

#include <span>
#include <string>
#include <string_view>

#include "services/cli/console/command_context.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Program with commands, as its help describes it.
struct ProgramInfo {
  std::string name;
  std::string description;
  std::string footer;
};

/// Function that adds a command to the program. `app` and `context` outlive the parsing and the run
/// of the command.
using AddCommand = void (*)(CLI::App& app, CommandContext& context);

/// Returns "slicefarm 0.1.0 (date), build id".
std::string VersionLine(std::string_view program);

/// Parses the command line and runs its command. Returns the exit code of the program. Errors are
/// printed to stderr.
int RunProgram(const ProgramInfo& program, std::span<const AddCommand> commands, int argc,
               char** argv);

}  // namespace slicefarm::cli
