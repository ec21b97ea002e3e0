#pragma once

namespace slicefarm::cli {

/// Runs `slicefarm`: reads the command line and runs the command. Returns the exit code.
int Main(int argc, char** argv);

}  // namespace slicefarm::cli
