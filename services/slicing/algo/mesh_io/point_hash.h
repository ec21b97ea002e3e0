#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace slicefarm::slicing {

/// Keyed hash of three 64-bit words. An attacker cannot compute collisions without the keys, so no
/// file can be crafted to overload a hash table.
class PointHash {
 public:
  using Keys = std::array<uint64_t, 4>;

  explicit PointHash(const Keys& keys) : keys_(keys) {}

  /// Returns the hash function of this program. Its keys are random and constant while the program
  /// runs.
  static const PointHash& OfProcess() {
    static const PointHash hash{RandomKeys()};
    return hash;
  }

  /// Returns the hash of the three words.
  uint64_t operator()(const std::array<uint64_t, 3>& words) const {
    const uint64_t first = Fold(words[0] ^ keys_[0], words[1] ^ keys_[1]);
    return Fold(first ^ keys_[2], words[2] ^ keys_[3]);
  }

 private:
  static Keys RandomKeys() {
    std::random_device random;
    Keys keys;
    for (uint64_t& key : keys) key = uint64_t{random()} << 32 | random();
    return keys;
  }

  /// Combines both halves of the product. So every bit of the result depends on high and low bits
  /// of `a` and `b`.
  static uint64_t Fold(uint64_t a, uint64_t b) {
    const auto product = static_cast<unsigned __int128>(a) * b;
    return static_cast<uint64_t>(product) ^ static_cast<uint64_t>(product >> 64);
  }

  Keys keys_;
};

}  // namespace slicefarm::slicing
