#pragma once

namespace slicefarm::texture {

/// Starts the calling thread's sequence of random numbers for METIS.
///
/// METIS orders the unknowns of a system with numbers from `rand`, which it seeds each time. The C
/// library has one sequence for all threads, and gRPC's threads also take numbers from it. A number
/// taken by another thread would change METIS's order, and so the last digits of the map. Therefore
/// thread_random.cc replaces `rand` and `srand`: each thread has a separate sequence, with the same
/// numbers as the C library's. The ordering code calls this function, so programs with this library
/// always contain the replacements.
void SeedThreadRandom(unsigned int seed);

}  // namespace slicefarm::texture
