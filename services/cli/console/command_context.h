#pragma once

#include <functional>

#include "services/cli/console/exit_code.h"
#include "services/cli/console/interrupt.h"

namespace slicefarm::cli {

/// Shared data of the commands, and the work of the chosen one. Options are parsed first, then
/// `run` executes the function that the given command has stored in it.
struct CommandContext {
  Interrupt* interrupt = nullptr;
  std::function<ExitCode()> run;
};

}  // namespace slicefarm::cli
