#pragma once

namespace slicefarm::coordinator {

/// main() of `slicefarm-coordinator migrate`: brings a PostgreSQL database to the schema of this
/// build, beside coordinators that work, and prints each step that it took. May be ended and run
/// again. Returns the exit code.
int Migrate(int argc, char** argv);

}  // namespace slicefarm::coordinator
