#pragma once

#include <vector>

#include "common/model/fields/material_field.h"
#include "services/motion/algo/firmware/firmware.h"
#include "common/gcode/gcode_text.h"

namespace slicefarm::motion {

/// Moves are cut to this length where materials mix, mm: a mix holds for a whole move.
inline constexpr double kMixedMoveMm = 1;

/// Tells a mixing extruder what to mix, whenever a share changes by more than the field's step.
class MaterialMix {
 public:
  /// Both must outlive this; `field` null: nothing is mixed.
  MaterialMix(const Firmware& firmware, const MaterialField* field)
      : firmware_(firmware), field_(field) {}

  /// For beads at a place on the plate.
  void SetFor(const PlaceMm& place_mm, GcodeText& out);
  /// The mix is told anew.
  void Forget() { told_.clear(); }

 private:
  const Firmware& firmware_;
  const MaterialField* field_;
  std::vector<double> told_;  ///< empty: nothing
};

}  // namespace slicefarm::motion
