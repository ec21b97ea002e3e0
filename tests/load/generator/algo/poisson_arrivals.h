#pragma once

#include <cstdint>

#include "tests/load/generator/algo/seeded.h"

namespace slicefarm::load {

/// Start times of requests: a Poisson process, as from many independent clients that do not wait
/// for the server. The same seed gives the same times.
class PoissonArrivals {
 public:
  /// Creates a process with this mean rate. REQUIRES: rate_rps > 0.
  PoissonArrivals(double rate_rps, uint64_t seed) : rate_rps_(rate_rps), random_(seed) {}

  /// Returns the next start time, in ns since the run began. Start times never decrease.
  int64_t NextNs();

 private:
  const double rate_rps_;
  SeededRandom random_;
  double at_s_ = 0;
};

}  // namespace slicefarm::load
