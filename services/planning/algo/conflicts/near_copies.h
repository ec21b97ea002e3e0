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

/// Position of one copy relative to a copy of another object, or to another copy of the same
/// object.
struct Beside {
  int32_t object = 0;
  Point shift;  ///< vector from the copy that was asked for (NearCopies::Of) to this copy

  friend auto operator<=>(const Beside&, const Beside&) = default;
};

/// Finds copies that may overlap, from the bounding boxes of their objects in the layers so far.
/// The boxes grow layer by layer. Pairs of copies with the same objects and the same relative
/// position count once. Cost: O(c log c) for c copies, plus the pairs that are near, each time that
/// an object grows by some millimetres.
class NearCopies {
 public:
  /// `copies` must outlive this object.
  explicit NearCopies(std::span<const PlacedCopy> copies) : copies_(copies) {}

  /// Extends the bounding box of `object` by `box`, which is in the object's own coordinates.
  void Claim(int32_t object, const Box& box);

  /// Returns the copies that may overlap a copy of `object`, with their positions relative to this
  /// copy. The result holds for all copies of the object together.
  const std::set<Beside>& Of(int32_t object);

 private:
  void Sweep();

  const std::span<const PlacedCopy> copies_;
  std::map<int32_t, Box> claims_;  ///< bounding box per object
  bool stale_ = false;
  std::map<int32_t, std::set<Beside>> near_;  ///< neighbours per object
};

}  // namespace slicefarm::planning
