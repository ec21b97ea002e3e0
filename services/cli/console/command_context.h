#pragma once

#include <functional>

#include "services/cli/console/exit_code.h"
#include "services/cli/console/interrupt.h"

namespace slicefarm::cli {

/// What a command needs besides its options, and its work: options are parsed first, then `run`
/// does what the given command left there.
struct CommandContext {
  Interrupt* interrupt = nullptr;
  std::function<ExitCode()> run;
};

}  // namespace slicefarm::cli
