#pragma once

#include <optional>
#include <vector>

#include "common/geometry/box_index.h"
#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::ordering {

/// Areas of a section that are over air, for queries about walls.
class AirBelow {
 public:
  /// `air` must outlive this object.
  explicit AirBelow(const MultiPolygon& air) : air_(air), index_(air) {}

  bool empty() const { return air_.empty(); }

  /// Returns true if the centre line of a closed wall is over air. Cost: boolean operations with
  /// the areas near the wall, if all its points are over air. The first such wall costs an offset
  /// of all areas.
  bool IsUnder(const Path& wall);

 private:
  /// Areas that are a little larger, so that rounding does not matter.
  struct Grown {
    MultiPolygon air;
    BoxIndex index;
  };

  const MultiPolygon& air_;
  BoxIndex index_;
  std::optional<Grown> grown_;  ///< made when first needed
};

/// Removes from `walls` the contours that are over air alone, and returns them: all of a contour's
/// walls are closed, and their centre lines are in `air`. A contour with a wall that rests on
/// something can be printed from that wall outwards, so it remains. Cost: see AirBelow::IsUnder.
std::vector<Path*> TakeUnsupported(std::vector<Path*>& walls, AirBelow& air);

}  // namespace slicefarm::ordering
