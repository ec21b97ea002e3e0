#pragma once

#include <cstdint>

namespace slicefarm {

// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators",
// OOPSLA 2014): random bits that are equal on all machines.

/// Difference of the generator's consecutive states.
inline constexpr uint64_t kSplitMixStep = 0x9E3779B97F4A7C15;

/// Returns well-mixed bits for a state; also usable as a hash.
inline constexpr uint64_t MixedBits(uint64_t state) {
  state = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
  state = (state ^ (state >> 27)) * 0x94D049BB133111EB;
  return state ^ (state >> 31);
}

/// Returns bits as a number in [0, 1).
inline constexpr double ShareOfBits(uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

/// Generator of random numbers from a seed.
class SplitMix {
 public:
  explicit constexpr SplitMix(uint64_t seed) : state_(seed) {}

  /// Returns 64 random bits.
  constexpr uint64_t Bits() { return MixedBits(state_ += kSplitMixStep); }
  /// Returns a number in [0, 1).
  constexpr double Share() { return ShareOfBits(Bits()); }

 private:
  uint64_t state_;
};

}  // namespace slicefarm
