#pragma once

namespace slicefarm::coordinator {

/// main() of `slicefarm-coordinator migrate`: brings a PostgreSQL database to the schema of this
/// build, while coordinators run, and prints each step. May be interrupted and run again. Returns
/// the exit code.
int Migrate(int argc, char** argv);

}  // namespace slicefarm::coordinator
