#pragma once

#include <cstdint>
#include <string>

#include "common/base/split_mix.h"

namespace slicefarm::load {

/// Stream of random numbers. The same seed gives the same numbers with every compiler and library.
class SeededRandom {
 public:
  explicit SeededRandom(uint64_t seed) : random_(seed) {}

  /// Returns the independent stream of the `index`-th item of a run.
  static SeededRandom Of(uint64_t seed, uint64_t index);

  /// Returns 64 random bits.
  uint64_t Bits() { return random_.Bits(); }
  /// Returns a number in [0, 1).
  double Uniform() { return random_.Share(); }
  /// Returns a number in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

 private:
  SplitMix random_;
};

/// Returns a UUID (version 4 in form) for a request. The same seed and index give the same UUID.
std::string RequestId(uint64_t seed, uint64_t index);

}  // namespace slicefarm::load
