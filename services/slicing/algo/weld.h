#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace slicefarm::slicing {

/// Gives equal points the same number, in order of first appearance. `T` is three 8-byte
/// coordinates whose bits tell equality (a double zero must be +0.0).
///
/// Open addressing over indices: 4 bytes a slot at most half full, besides the points. Cost: O(1) a
/// point; the hash is seeded by nothing, so a file made to collide costs O(n) a point and is
/// bounded by the triangle limit only.
template <typename T>
class Welder {
  static_assert(sizeof(T) == 24);

 public:
  /// Room for `expected` distinct points without growing.
  explicit Welder(size_t expected) : slots_(std::bit_ceil(2 * expected + 16), kEmpty) {
    points_.reserve(expected);
  }

  /// The number of the point.
  uint32_t Add(const T& point) {
    if (2 * points_.size() >= slots_.size()) Grow();
    const size_t slot = FindSlot(point);
    if (slots_[slot] == kEmpty) {
      slots_[slot] = static_cast<uint32_t>(points_.size());
      points_.push_back(point);
    }
    return slots_[slot];
  }

  /// The distinct points, by number. The welder is spent afterwards.
  std::vector<T> TakePoints() && { return std::move(points_); }

 private:
  static constexpr uint32_t kEmpty = UINT32_MAX;

  static uint64_t Hash(const T& point) {
    const auto bits = std::bit_cast<std::array<uint64_t, 3>>(point);
    uint64_t hash = bits[0] * 0x9E3779B97F4A7C15u;
    hash = (std::rotl(hash, 29) ^ bits[1]) * 0xBF58476D1CE4E5B9u;
    hash = (std::rotl(hash, 29) ^ bits[2]) * 0x94D049BB133111EBu;
    return hash ^ (hash >> 32);
  }

  static bool SameBits(const T& a, const T& b) {
    return std::bit_cast<std::array<uint64_t, 3>>(a) == std::bit_cast<std::array<uint64_t, 3>>(b);
  }

  size_t FindSlot(const T& point) const {
    const size_t mask = slots_.size() - 1;
    size_t slot = Hash(point) & mask;
    while (slots_[slot] != kEmpty && !SameBits(points_[slots_[slot]], point))
      slot = (slot + 1) & mask;
    return slot;
  }

  void Grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (uint32_t i = 0; i < points_.size(); ++i) slots_[FindSlot(points_[i])] = i;
  }

  std::vector<uint32_t> slots_;
  std::vector<T> points_;
};

}  // namespace slicefarm::slicing
