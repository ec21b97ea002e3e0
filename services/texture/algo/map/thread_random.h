#pragma once

namespace slicefarm::texture {

/// METIS orders the unknowns of a system by `rand`, which it seeds each time. The C library has one
/// sequence for all threads, and gRPC's threads take numbers of it as well: now and then one of
/// these came in between, and the map's last digits were others. So each thread of a program with
/// this library has a sequence of its own, the same as the C library's: thread_random.cc takes the
/// place of `rand` and `srand`.
///
/// Starts the calling thread's sequence. Who orders calls it, so that a program with this library
/// has those.
void SeedThreadRandom(unsigned int seed);

}  // namespace slicefarm::texture
