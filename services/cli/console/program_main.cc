#include "services/cli/console/program_main.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>

#include "common/base/build_info.h"
#include "services/cli/console/exit_code.h"
#include "services/cli/console/interrupt.h"
#include "services/cli/console/parse_errors.h"

namespace slicefarm::cli {
namespace {

ExitCode Parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return static_cast<ExitCode>(app.exit(error));  // help, version
    fmt::print(stderr, "error: {}\n", ParseErrorText(app, error));
    return ExitCode::kUsage;
  }
  return ExitCode::kOk;
}

ExitCode Run(const ProgramInfo& program, std::span<const AddCommand> commands, int argc,
             char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a write error instead
  Interrupt interrupt;
  CommandContext context = {.interrupt = &interrupt, .run = {}};
  CLI::App app(program.description, program.name);
  app.footer(program.footer);
  app.set_version_flag("-v,--version", VersionLine(program.name));
  app.require_subcommand(1);
  for (const AddCommand add : commands) add(app, context);
  if (const ExitCode parsed = Parse(app, argc, argv); parsed != ExitCode::kOk || !context.run) {
    return parsed;
  }
  return context.run();
}

}  // namespace

std::string VersionLine(std::string_view program) {
  return fmt::format("{} {} ({}), build {}", program, Version(), ReleaseDate(), BuildId());
}

int RunProgram(const ProgramInfo& program, std::span<const AddCommand> commands, int argc,
               char** argv) {
  try {
    return static_cast<int>(Run(program, commands, argc, argv));
  } catch (const std::exception& error) {  // most likely out of memory
    fmt::print(stderr, "error: {}\n", error.what());
    return static_cast<int>(ExitCode::kInternal);
  }
}

}  // namespace slicefarm::cli
