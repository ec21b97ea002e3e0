#pragma once

#include <cstdint>
#include <string>

namespace slicefarm::load {

/// Stream of random numbers. The same seed gives the same numbers with every compiler and library.
/// Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
class SeededRandom {
 public:
  explicit SeededRandom(uint64_t seed) : state_(seed) {}

  /// Returns the independent stream of the `index`-th item of a run.
  static SeededRandom Of(uint64_t seed, uint64_t index);

  /// Returns 64 random bits.
  uint64_t Bits();
  /// Returns a number in [0, 1).
  double Uniform();
  /// Returns a number in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

 private:
  uint64_t state_;
};

/// Returns a UUID (version 4 in form) for a request. The same seed and index give the same UUID.
std::string RequestId(uint64_t seed, uint64_t index);

}  // namespace slicefarm::load
