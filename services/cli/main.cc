#include "services/cli/cli_program.h"

int main(int argc, char** argv) { return slicefarm::cli::Main(argc, argv); }
