#pragma once

#include <cstdint>

namespace slicefarm::coordinator::sim {

/// Random numbers from a seed, equal on every machine: SplitMix64 (Steele, Lea and Flood, "Fast
/// Splittable Pseudorandom Number Generators", OOPSLA 2014).
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /// Returns the next number.
  uint64_t Next() {
    state_ += 0x9e3779b97f4a7c15;
    return Mix(state_);
  }

  /// Returns a number in [first, last].
  int64_t Between(int64_t first, int64_t last) {
    return first + static_cast<int64_t>(Next() % static_cast<uint64_t>(last - first + 1));
  }
  /// Returns a number in [0, count).
  int Below(int count) { return static_cast<int>(Between(0, count - 1)); }
  /// Returns true with a probability of `permille` / 1000.
  bool Chance(int permille) { return Below(1000) < permille; }

  /// Returns the value with its bits mixed; also usable as a hash.
  static uint64_t Mix(uint64_t value) {
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
    value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
    return value ^ (value >> 31);
  }

 private:
  uint64_t state_;
};

}  // namespace slicefarm::coordinator::sim
