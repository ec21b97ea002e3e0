#pragma once

#include <cstdint>

#include "common/base/split_mix.h"

namespace slicefarm::coordinator::sim {

/// Random numbers from a seed, equal on every machine.
class Random {
 public:
  explicit Random(uint64_t seed) : bits_(seed) {}

  /// Returns the next number.
  uint64_t Next() { return bits_.Bits(); }

  /// Returns a number in [first, last].
  int64_t Between(int64_t first, int64_t last) {
    return first + static_cast<int64_t>(Next() % static_cast<uint64_t>(last - first + 1));
  }
  /// Returns a number in [0, count).
  int Below(int count) { return static_cast<int>(Between(0, count - 1)); }
  /// Returns true with a probability of `permille` / 1000.
  bool Chance(int permille) { return Below(1000) < permille; }

 private:
  SplitMix bits_;
};

}  // namespace slicefarm::coordinator::sim
