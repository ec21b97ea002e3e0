#pragma once

namespace slicefarm::coordinator {

/// main() of slicefarm-coordinator: serves until a signal comes. Returns the exit code.
int Main(int argc, char** argv);

}  // namespace slicefarm::coordinator
