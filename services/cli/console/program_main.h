#pragma once

#include <span>
#include <string>
#include <string_view>

#include "services/cli/console/command_context.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Description of a program with commands, as in its help.
struct ProgramInfo {
  std::string name;
  std::string description;
  std::string footer;
};

/// Function that adds a command to the program. `app` and `context` outlive the parsing and the
/// run.
using AddCommand = void (*)(CLI::App& app, CommandContext& context);

/// Returns "slicefarm 0.1.0 (date), build id".
std::string VersionLine(std::string_view program);

/// Runs the command of the command line. Returns the exit code of the process. Errors are printed
/// to stderr.
int RunProgram(const ProgramInfo& program, std::span<const AddCommand> commands, int argc,
               char** argv);

}  // namespace slicefarm::cli
