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

/// How a copy stands beside one of an object.
struct Beside {
  int32_t object = 0;
  Point shift;  ///< from the other object's copy to this one

  friend auto operator<=>(const Beside&, const Beside&) = default;
};

/// Which copies may share room, as far as what is known of their objects reaches: objects are told
/// of layer by layer, and copies that stand as two others do count once.
/// Cost: O(c log c) for c copies each time that an object grows by some millimetres, and what is
/// near.
class NearCopies {
 public:
  /// `copies` must outlive this.
  explicit NearCopies(std::span<const PlacedCopy> copies) : copies_(copies) {}

  /// `object` has something there, in its own coordinates.
  void Claim(int32_t object, const Box& box);

  /// What may meet the object's copies.
  const std::set<Beside>& Of(int32_t object);

 private:
  void Sweep();

  const std::span<const PlacedCopy> copies_;
  std::map<int32_t, Box> claims_;  ///< by object
  bool stale_ = false;
  std::map<int32_t, std::set<Beside>> near_;  ///< by object
};

}  // namespace slicefarm::planning
