#include "services/cli/cli_program.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <string>

#include "common/base/build_info.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console.h"
#include "services/cli/exit_code.h"
#include "services/cli/interrupt.h"
#include "services/cli/parse_errors.h"

namespace slicefarm::cli {
namespace {

std::string VersionLine() {
  return fmt::format("slicefarm {} ({}), build {}", Version(), ReleaseDate(), BuildId());
}

}  // namespace

void AddVersion(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("version", "Print version and build");
  command->callback([&context] {
    context.run = [] {
      Print(VersionLine() + "\n");
      return ExitCode::kOk;
    };
  });
}

namespace {

constexpr char kDescription[] =
    "slicefarm turns 3D models into G-code: here (slice), or on a farm (submit).";

constexpr char kFooter[] =
    "`slicefarm COMMAND --help` tells more, with examples. To begin with:\n"
    "  slicefarm slice part.stl -o part.gcode\n"
    "  slicefarm slice part.stl -o part.gcode --config prusa.ini --set fill_density=30%\n"
    "  slicefarm render part.gcode --layer 12 -o layer.png\n"
    "\n"
    "Exit codes:\n"
    "  0  done\n"
    "  1  a fault of slicefarm's own; of `check`: the file has findings\n"
    "  2  wrong command line, or an input file that cannot be read\n"
    "  3  a setting is unknown, malformed or out of range\n"
    "  4  the model cannot be read, does not fit or has nothing to print\n"
    "  5  the server cannot be reached, or not in time\n"
    "  6  the job failed on the server, or its bytes are spoilt there\n"
    "  7  cancelled\n"
    "  8  no such job, or it has no result\n"
    "  9  the output cannot be written\n"
    "  10 the farm takes no more at the moment (--patience S waits): quota, queue or disk";

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

ExitCode Run(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that went away is an error of writing
  Interrupt interrupt;
  CommandContext context = {.interrupt = &interrupt, .run = {}};
  CLI::App app(kDescription, "slicefarm");
  app.footer(kFooter);
  app.set_version_flag("-v,--version", VersionLine());
  app.require_subcommand(1);
  for (const auto add : {AddSlice,     AddSubmit,  AddInspect,        AddWatch,
                         AddList,      AddGet,     AddCancel,         AddDelete,
                         AddTrace,     AddWebhook, AddUpdate,         AddArtifacts,
                         AddEvents,    AddMeshes,  AddUsage,          AddCaller,
                         AddTenant,    AddProfile, AddRender,         AddBeads,
                         AddFill,      AddFlatten, AddDecompose,      AddSupportLab,
                         AddTsp,       AddTime,    AddCheck,          AddSettings,
                         AddHealth,    AddToken,   AddEngraveProgram, AddMillProgram,
                         AddWaterline, AddHelp,    AddCompletion,     AddVersion}) {
    add(app, context);
  }
  if (const ExitCode parsed = Parse(app, argc, argv); parsed != ExitCode::kOk || !context.run) {
    return parsed;
  }
  return context.run();
}

}  // namespace

int Main(int argc, char** argv) {
  try {
    return static_cast<int>(Run(argc, argv));
  } catch (const std::exception& error) {  // memory ran out, most likely
    fmt::print(stderr, "error: {}\n", error.what());
    return static_cast<int>(ExitCode::kInternal);
  }
}

}  // namespace slicefarm::cli
