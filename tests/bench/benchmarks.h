#pragma once

namespace slicefarm::bench {

/// Each prints `key value` rows to stdout and returns the exit code.
int BenchSlice();
int BenchHop();

}  // namespace slicefarm::bench
