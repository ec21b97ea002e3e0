#include "services/cli/console/program_main.h"
#include "services/lab/commands.h"

namespace slicefarm::lab {
namespace {

constexpr cli::AddCommand kCommands[] = {AddBeads,   AddFill,      AddDecompose, AddTsp,
                                         AddFlatten, AddWaterline, AddSupportLab};

constexpr char kDescription[] =
    "slicefarm-lab runs one algorithm of slicefarm on a file, to examine it without a job.";

constexpr char kFooter[] =
    "`slicefarm-lab COMMAND --help` explains a command, with an example. Exit codes are those of "
    "slicefarm:\n0 success, 1 an internal error, 2 wrong command line or input, 3 to 9 as "
    "`slicefarm --help`\nlists them.";

}  // namespace
}  // namespace slicefarm::lab

int main(int argc, char** argv) {
  using namespace slicefarm;
  return cli::RunProgram({"slicefarm-lab", lab::kDescription, lab::kFooter}, lab::kCommands, argc,
                         argv);
}
