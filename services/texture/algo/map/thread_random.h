#pragma once

namespace slicefarm::texture {

/// METIS orders the unknowns of a system with numbers from `rand`, which it seeds each time. The C
/// library has one sequence for all threads, and gRPC's threads also take numbers from it. If
/// another thread took a number in between, the last digits of the map changed. So each thread of a
/// program with this library has a separate sequence, equal to the C library's one:
/// thread_random.cc replaces `rand` and `srand`.
///
/// This function starts the calling thread's sequence. The ordering code calls it, so programs with
/// this library always contain the replacements.
void SeedThreadRandom(unsigned int seed);

}  // namespace slicefarm::texture
