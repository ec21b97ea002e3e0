#pragma once

namespace slicefarm::cli {

/// main() of `slicefarm`: reads the command line, runs the command. Returns the exit code.
int Main(int argc, char** argv);

}  // namespace slicefarm::cli
