#pragma once

#include <functional>

#include "services/cli/console/exit_code.h"
#include "services/cli/console/interrupt.h"

namespace slicefarm::cli {

/// Data that the commands share, and the work of the chosen command. During parsing, the given
/// command stores its function in `run`; afterwards the program calls `run`.
struct CommandContext {
  Interrupt* interrupt = nullptr;
  std::function<ExitCode()> run;
};

}  // namespace slicefarm::cli
