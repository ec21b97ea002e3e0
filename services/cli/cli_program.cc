#include "services/cli/cli_program.h"

#include <CLI/CLI.hpp>

#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/console/program_main.h"

namespace slicefarm::cli {
namespace {

constexpr char kProgram[] = "slicefarm";

}  // namespace

void AddVersion(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("version", "Print version and build");
  command->callback([&context] {
    context.run = [] {
      Print(VersionLine(kProgram) + "\n");
      return ExitCode::kOk;
    };
  });
}

namespace {

constexpr char kDescription[] =
    "slicefarm turns 3D models into G-code: on this machine (slice) or on a farm (submit).";

constexpr char kFooter[] =
    "`slicefarm COMMAND --help` explains a command, with examples. To begin with:\n  slicefarm "
    "slice part.stl -o part.gcode\n  slicefarm slice part.stl -o part.gcode --config prusa.ini "
    "--set fill_density=30%\n  slicefarm render part.gcode --layer 12 -o layer.png\n\nExit "
    "codes:\n  0  success\n  1  an internal error of slicefarm; for `check`: the file has "
    "findings\n  2  wrong command line, or an input file that cannot be read\n  3  a setting is "
    "unknown, malformed or out of range\n  4  the model cannot be read, does not fit or has "
    "nothing to print\n  5  the server cannot be reached, or did not answer in time\n  6  the job "
    "failed on the server, or its result is damaged there\n  7  cancelled\n  8  no such job or "
    "preset, or "
    "the job has no result\n  9  the output cannot be written\n  10 the farm accepts no more jobs "
    "now "
    "(--patience S waits): quota, queue or disk";

constexpr AddCommand kCommands[] = {
    AddSlice,     AddCalibrate, AddSubmit, AddInspect,    AddWatch,   AddList,
    AddGet,       AddCancel,    AddDelete, AddTrace,      AddWebhook, AddUpdate,
    AddArtifacts, AddEvents,    AddMeshes, AddUsage,      AddCaller,  AddTenant,
    AddProfile,   AddPresets,   AddRender, AddTime,       AddCheck,   AddSettings,
    AddHealth,    AddToken,     AddHelp,   AddCompletion, AddVersion};

}  // namespace

int Main(int argc, char** argv) {
  return RunProgram({kProgram, kDescription, kFooter}, kCommands, argc, argv);
}

}  // namespace slicefarm::cli
