#pragma once

#include <cstdint>

namespace slicefarm::beading {

// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, 2014): random bits that are equal on all machines.

/// Difference of the generator's consecutive states.
inline constexpr uint64_t kSplitMixStep = 0x9E3779B97F4A7C15;

/// Returns well-mixed bits for a state.
inline uint64_t MixedBits(uint64_t state) {
  state = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9;
  state = (state ^ (state >> 27)) * 0x94D049BB133111EB;
  return state ^ (state >> 31);
}

/// Returns bits as a number in [0, 1).
inline double UnitOf(uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

}  // namespace slicefarm::beading
