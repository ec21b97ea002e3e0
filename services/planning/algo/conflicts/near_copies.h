#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <span>

#include "common/geometry/measure.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::planning {

/// Position of a copy relative to a copy of another object.
struct Beside {
  int32_t object = 0;
  Point shift;  ///< vector from the other object's copy to this copy

  friend auto operator<=>(const Beside&, const Beside&) = default;
};

/// Finds copies that may share room, from the boxes of their objects so far. The boxes grow layer
/// by layer. Pairs of copies with the same objects and the same relative position count once.
/// Cost: O(c log c) for c copies, plus the pairs that are near, each time that an object grows by
/// some millimetres.
class NearCopies {
 public:
  /// `copies` must outlive this object.
  explicit NearCopies(std::span<const PlacedCopy> copies) : copies_(copies) {}

  /// Adds a box, in the object's own coordinates, to the room of `object`.
  void Claim(int32_t object, const Box& box);

  /// Returns the neighbours that may meet the object's copies.
  const std::set<Beside>& Of(int32_t object);

 private:
  void Sweep();

  const std::span<const PlacedCopy> copies_;
  std::map<int32_t, Box> claims_;  ///< claimed boxes by object
  bool stale_ = false;
  std::map<int32_t, std::set<Beside>> near_;  ///< neighbours by object
};

}  // namespace slicefarm::planning
