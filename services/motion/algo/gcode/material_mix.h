#pragma once

#include <vector>

#include "common/model/fields/material_field.h"
#include "services/motion/algo/gcode/gcode_text.h"

namespace slicefarm::motion {

/// Moves are cut to this length where materials mix, mm: a mix holds for a whole move.
inline constexpr double kMixedMoveMm = 1;

/// Tells a mixing extruder what to mix: M163 for each material, M164 to store it as tool 0, whenever
/// a share changes by more than the field's step (Marlin, MIXING_EXTRUDER).
class MaterialMix {
 public:
  /// `field` must outlive this; null: nothing is mixed.
  explicit MaterialMix(const MaterialField* field) : field_(field) {}

  /// For beads at a place on the plate.
  void SetFor(const PlaceMm& place_mm, GcodeText& out);
  /// The mix is told anew.
  void Forget() { told_.clear(); }

 private:
  const MaterialField* field_;
  std::vector<double> told_;  ///< empty: nothing
};

}  // namespace slicefarm::motion
