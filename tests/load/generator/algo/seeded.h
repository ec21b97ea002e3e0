#pragma once

#include <cstdint>
#include <string>

namespace slicefarm::load {

/// A stream of random numbers that is the same for the same seed with every compiler and library.
/// Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
class SeededRandom {
 public:
  explicit SeededRandom(uint64_t seed) : state_(seed) {}

  /// The stream of the `index`-th thing of a run, independent of the others.
  static SeededRandom Of(uint64_t seed, uint64_t index);

  uint64_t Bits();
  /// In [0, 1).
  double Uniform();
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

 private:
  uint64_t state_;
};

/// A UUID (version 4 in form) for a request. The same seed and index give the same one.
std::string RequestId(uint64_t seed, uint64_t index);

}  // namespace slicefarm::load
