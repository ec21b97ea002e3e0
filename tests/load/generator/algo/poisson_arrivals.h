#pragma once

#include <cstdint>

#include "tests/load/generator/algo/seeded.h"

namespace slicefarm::load {

/// The instants at which requests are to start: a Poisson process, as of many clients that know
/// nothing of each other and do not wait for the server. The same seed gives the same instants.
class PoissonArrivals {
 public:
  /// REQUIRES: rate_rps > 0.
  PoissonArrivals(double rate_rps, uint64_t seed) : rate_rps_(rate_rps), random_(seed) {}

  /// Nanoseconds from the beginning of the run; never less than the one before.
  int64_t NextNs();

 private:
  const double rate_rps_;
  SeededRandom random_;
  double at_s_ = 0;
};

}  // namespace slicefarm::load
