#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "services/slicing/algo/mesh_io/point_hash.h"

namespace slicefarm::slicing {

/// Gives equal points the same number, in order of first appearance. `T` is three 8-byte
/// coordinates whose bits tell equality (a double zero must be +0.0).
///
/// Open addressing over indices: 4 bytes a slot at most half full, besides the points. Cost: O(1) a
/// point, also for a file that was made to collide: the hash has random keys. No output depends on
/// them, as the numbers follow first appearance and not the slots.
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

  static std::array<uint64_t, 3> Bits(const T& point) {
    std::array<uint64_t, 3> bits;
    std::memcpy(bits.data(), &point, sizeof bits);
    return bits;
  }

  static bool SameBits(const T& a, const T& b) { return Bits(a) == Bits(b); }

  size_t FindSlot(const T& point) const {
    const size_t mask = slots_.size() - 1;
    size_t slot = hash_(Bits(point)) & mask;
    while (slots_[slot] != kEmpty && !SameBits(points_[slots_[slot]], point))
      slot = (slot + 1) & mask;
    return slot;
  }

  void Grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (uint32_t i = 0; i < points_.size(); ++i) slots_[FindSlot(points_[i])] = i;
  }

  PointHash hash_ = PointHash::OfProcess();
  std::vector<uint32_t> slots_;
  std::vector<T> points_;
};

}  // namespace slicefarm::slicing
