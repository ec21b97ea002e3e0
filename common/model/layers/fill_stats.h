#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/options/fill_patterns.h"
#include "common/model/path.h"

namespace slicefarm {

/// Totals of the infill of one kind. A kind is a combination of region settings, feature and
/// pattern.
struct FillStats {
  int32_t settings = 0;  ///< index into the job's tables of region settings
  Feature feature = Feature::kInternalInfill;
  /// Pattern; nullopt for lines that follow stresses or support an overhang.
  std::optional<FillPattern> pattern;
  double area_mm2 = 0;     ///< filled area, summed over all layers
  double volume_mm3 = 0;   ///< filled area times the height of the beads
  double asked_mm3 = 0;    ///< plastic that the settings require for `volume_mm3`
  double plastic_mm3 = 0;  ///< volume of the beads, including links between lines
  int64_t paths = 0;
  double length_mm = 0;
  double longest_mm = 0;  ///< length of the longest path

  /// Adds the totals of `other`, multiplied by `copies`. `longest_mm` becomes the maximum of both.
  void Add(const FillStats& other, int64_t copies);
  friend bool operator==(const FillStats&, const FillStats&) = default;
};

/// Adds the totals of `use`, multiplied by `copies`, to the entry of the same kind in `uses`.
/// `uses` has one entry per kind, sorted by settings, feature and pattern. Cost: O(uses).
void AddUse(const FillStats& use, int64_t copies, std::vector<FillStats>& uses);

}  // namespace slicefarm
