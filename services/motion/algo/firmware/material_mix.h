#pragma once

#include <vector>

#include "common/gcode/gcode_text.h"
#include "common/model/fields/material_field.h"
#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Longest move in mm while materials mix. Longer moves are divided, because one move has one mix.
inline constexpr double kMixedMoveMm = 1;

/// Writes the mix of a mixing extruder each time that a material's share differs by more than
/// MaterialField::step from the share written last.
class MaterialMix {
 public:
  /// `firmware` and `field` must outlive this object. A null `field` turns mixing off.
  MaterialMix(const Firmware& firmware, const MaterialField* field)
      : firmware_(firmware), field_(field) {}

  /// Writes the mix for a bead that ends at this position on the plate, if the mix has changed.
  void SetFor(const PositionMm& position_mm, GcodeText& out);
  /// Forces the next mix to be written even if it is unchanged.
  void Forget() { written_.clear(); }

 private:
  const Firmware& firmware_;
  const MaterialField* field_;
  std::vector<double> written_;  ///< mix written last; empty: none
};

}  // namespace slicefarm::motion
