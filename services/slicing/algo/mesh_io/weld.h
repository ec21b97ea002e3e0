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

/// Welder that gives equal points the same index, in order of first appearance. `T` has three
/// 8-byte coordinates. Points are equal if their bits are equal (a double zero must be +0.0).
///
/// It is an open-addressing hash table of indices: 4 bytes per slot, at most half full, in addition
/// to the points. The cost is O(1) per point, even for a file crafted to cause collisions, because
/// the hash has random keys. The output does not depend on the keys, because the indices follow the
/// first appearance.
template <typename T>
class Welder {
  static_assert(sizeof(T) == 24);

 public:
  /// Reserves memory for `expected` distinct points.
  explicit Welder(size_t expected) : slots_(std::bit_ceil(2 * expected + 16), kEmpty) {
    points_.reserve(expected);
  }

  /// Returns the index of the point, and adds the point if it is new.
  uint32_t Add(const T& point) {
    if (2 * points_.size() >= slots_.size()) Grow();
    const size_t slot = FindSlot(point);
    if (slots_[slot] == kEmpty) {
      slots_[slot] = static_cast<uint32_t>(points_.size());
      points_.push_back(point);
    }
    return slots_[slot];
  }

  /// Returns the distinct points, sorted by index. The welder must not be used afterwards.
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
