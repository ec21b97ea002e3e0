#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/options/fill_patterns.h"
#include "common/model/path.h"

namespace slicefarm {

/// What infill of one kind comes to: of one region's settings, for one feature, by one pattern.
struct FillUse {
  int32_t settings = 0;  ///< row of the job's tables of region settings
  Feature feature = Feature::kInternalInfill;
  std::optional<FillPattern> pattern;  ///< none: lines follow stresses, or what bears an overhang
  double area_mm2 = 0;                 ///< of what is filled, of all layers together
  double room_mm3 = 0;                 ///< that area, as high as the beads in it
  double asked_mm3 = 0;                ///< plastic that the settings ask for in that room
  double plastic_mm3 = 0;              ///< of the beads, links included
  int64_t paths = 0;
  double length_mm = 0;
  double longest_mm = 0;  ///< of one path

  /// Adds what so many copies of `other` come to.
  void Add(const FillUse& other, int64_t copies);
  friend bool operator==(const FillUse&, const FillUse&) = default;
};

/// Adds so many copies of a use to that of the same kind. `uses`: one a kind, by settings, feature
/// and pattern. Cost: O(uses).
void AddUse(const FillUse& use, int64_t copies, std::vector<FillUse>& uses);

}  // namespace slicefarm
