#pragma once

#include <vector>

#include "common/gcode/gcode_text.h"
#include "common/model/fields/material_field.h"
#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Longest move while materials mix, in mm. Longer moves are cut, because one mix is used for a
/// whole move.
inline constexpr double kMixedMoveMm = 1;

/// Writes the mix of a mixing extruder, whenever a share changes by more than the field's step.
class MaterialMix {
 public:
  /// `firmware` and `field` must outlive this object. A null `field` turns mixing off.
  MaterialMix(const Firmware& firmware, const MaterialField* field)
      : firmware_(firmware), field_(field) {}

  /// Writes the mix for beads at a position on the plate, if the mix has changed.
  void SetFor(const PlaceMm& place_mm, GcodeText& out);
  /// Forces the next mix to be written even if it is unchanged.
  void Forget() { told_.clear(); }

 private:
  const Firmware& firmware_;
  const MaterialField* field_;
  std::vector<double> told_;  ///< mix written last; empty: none
};

}  // namespace slicefarm::motion
