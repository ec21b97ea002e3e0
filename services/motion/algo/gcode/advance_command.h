#pragma once

#include <cstddef>
#include <optional>

#include "common/gcode/gcode_text.h"
#include "common/model/options/advance_model.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Adaptive pressure advance of a job (adaptive_pressure_advance).
struct AdvanceControl {
  AdvanceModel model;
  bool within_features = false;  ///< true: also where the flow changes within a feature
  double bridges = 0;            ///< pressure advance of bridges; 0: by the model
  double filament_mm2 = 0;       ///< section of the filament

  /// Returns the control of the options, or nullopt if it is off or has no values.
  static std::optional<AdvanceControl> Of(const MotionOptions& options);
};

/// Sets the pressure advance of the beads of a layer. Beads of one feature without another move
/// between them get one value, from their mean section and their highest speed. With
/// within_features, beads with one speed and one section get one value. As in OrcaSlicer, the speed
/// is the one after slowing down for cooling.
class AdvanceCommand {
 public:
  /// `firmware` and `control` must outlive the object; a null `control` sets nothing.
  AdvanceCommand(const Firmware& firmware, const AdvanceControl* control)
      : firmware_(firmware), control_(control) {}

  /// Writes the command for the bead `index` of a path, if the value changes there.
  void SetFor(const Toolpath& path, size_t index, GcodeText& out);
  /// Forces the value to be written again, because the text before may be skipped.
  void Forget() { written_ = -1; }

 private:
  size_t EndOfRun(const Toolpath& path, size_t first) const;
  double ValueOf(const Toolpath& path, size_t first, size_t last) const;

  const Firmware& firmware_;
  const AdvanceControl* control_;
  const Toolpath* path_ = nullptr;
  size_t first_ = 0, last_ = 0;  ///< current beads: [first_, last_) of path_
  double written_ = -1;          ///< value written last; -1: none
};

}  // namespace slicefarm::motion
