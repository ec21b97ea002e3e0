#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/gcode/gcode_text.h"
#include "common/gcode/modal.h"
#include "common/geometry/arc_fit.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/firmware/material_mix.h"
#include "services/motion/algo/gcode/advance_command.h"
#include "services/motion/algo/gcode/extruder_words.h"
#include "services/motion/algo/gcode/fan_command.h"
#include "services/motion/algo/macro/role_code.h"
#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/cooling.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Value of a fan speed that means: the fan speed is not changed.
inline constexpr int32_t kFanAsBefore = -1;

/// Values that are set when a layer's moves begin, and the fan speeds in percent for its kinds of
/// beads.
struct LayerState {
  int32_t height_um = -1;
  int32_t fan_percent = 0;         ///< fan speed of the layer; may be kFanAsBefore
  int32_t bridge_fan_percent = 0;  ///< fan speed for bridges and overhangs
  /// fan speeds for walls over air (cooling.h); nullopt without enable_dynamic_fan_speeds
  std::optional<OverhangFans> overhang_fan_percent = {};
  /// Walls with at most this supported share, in percent, get bridge_fan_percent; -1: no wall does.
  int32_t cooled_rest = -1;
  LineFans line_fans = {};  ///< fans for other kinds of lines
  FanLimits fan_limits = {};
  bool fan_is_off = false;     ///< true if the fan is off before the layer
  double fan_early_s = 0;      ///< time by which a faster fan starts before its beads
  bool fan_early_all = false;  ///< true: every faster fan starts early; false: that of bridges
  ShiftUm to_plate = {};       ///< shift from G-code coordinates to plate coordinates
  const AdvanceControl* advance = nullptr;  ///< null: no adaptive pressure advance
  const RoleTexts* roles = nullptr;         ///< null: no G-code between features
};

/// Writes moves as G-code, with the comments and modes that previewers and the firmware need:
/// `;TYPE:`, `;WIDTH:`, `;HEIGHT:`, accelerations and fan speed, each only where it changes. Feed
/// rates are written only where they change. A coordinate is left out if it equals the preceding
/// one in the same call of Write. The toolpath's arcs are written as G2 and G3 with the sum of
/// their filament.
class LayerWriter {
 public:
  /// `firmware` and `materials` must outlive the writer. `materials`: mix of materials at each
  /// position; null turns mixing off. `comments`: true to add a comment to each line.
  LayerWriter(const Firmware& firmware, const Accelerations& accelerations, const LayerState& state,
              const MaterialField* materials = nullptr, const ExtruderWords& extruder = {},
              bool comments = false)
      : firmware_(firmware),
        accelerations_(accelerations),
        state_(state),
        mix_(firmware, materials),
        extruder_(extruder),
        comments_(comments),
        height_um_(state.height_um),
        fan_(state.fan_limits, state.fan_percent),
        advance_(firmware, state.advance) {}

  /// Writes the command for the layer's fan speed.
  void WriteLayerFan(GcodeText& out);

  /// Appends the moves [first, last), shifted. May be called several times, one span after the
  /// other. The first move of each call has both coordinates. So the text does not depend on the
  /// text before it, and the machine may skip the copy before.
  void Write(const Toolpath& path, size_t first, size_t last, ShiftUm shift, GcodeText& out);

  /// Begins a block: the paths of a copy. The text of a block does not depend on the text before
  /// it, except for accelerations that are already set.
  void BeginBlock(GcodeText& out);
  /// Ends a block. Restores the fan speed and the height with which the layer began.
  void EndBlock(GcodeText& out);

  /// Tells the writer that custom G-code (a change of colour) has primed the filament. The next
  /// restart is then left out.
  void Prime() { primed_ = true; }

  /// Returns the lines that set a mode again although the machine may already have it
  /// (LayerProgram::mode_lines). They are necessary if the text before the layer is unknown.
  std::vector<ModeLine> TakeModeLines() { return std::move(mode_lines_); }
  /// Returns the modes after the written text. An empty value: this text has not set the mode.
  ModeValues Modes() const;

  /// Forces feed rate, acceleration and jerk to be written again, after inserted G-code that may
  /// have set them. A fan set by this G-code stays.
  void Forget() {
    feed_rate_.Forget();
    acceleration_ = -1;
    travel_acceleration_ = -1;
    jerk_ = -1;
  }

  /// Forces the next travel to write its height, after inserted G-code that moves the nozzle. The
  /// line of this travel is no mode line, so it is never left out.
  void ForgetPosition() {
    z_um_ = std::numeric_limits<int32_t>::min();
    approached_ = true;
  }

 private:
  void WriteMove(const Toolpath& path, size_t index, ShiftUm shift, GcodeText& out);
  void WriteIfNeeded(const Toolpath& path, size_t index, GcodeText& out);
  bool WriteByFirmware(const Move& move, GcodeText& out);
  void CountAnew(const Move& move, GcodeText& out);
  void WriteArc(const Toolpath& path, const MoveArc& arc, ShiftUm shift, GcodeText& out);
  void WriteWipe(bool wipes, GcodeText& out);
  void WritePosition(PointUm to, GcodeText& out);
  void WriteEnd(const Move& move, std::string_view comment, GcodeText& out);
  bool HasBridgeFan(const Move& move) const;
  int32_t OwnFan(Feature feature) const;
  int32_t FanFor(const Move& move) const;
  int32_t FanAhead(const Toolpath& path, size_t index) const;
  void SetFan(int32_t percent, GcodeText& out) { fan_.Set(state_.fan_limits.Raised(percent), out); }
  void WriteRole(Feature feature, GcodeText& out);
  void SetHeight(int32_t height_um, GcodeText& out);
  void Describe(const Move& move, double length_um, int32_t fan_percent, GcodeText& out);
  void SetAcceleration(const Move& move, GcodeText& out);
  void SetAcceleration(MachineMode mode, float value, float& written, GcodeText& out);
  void WriteAcceleration(MachineMode mode, float value, GcodeText& out) const;
  void SetJerk(const Move& move, GcodeText& out);
  void FeedRate(const Move& move, GcodeText& out);

  const Firmware& firmware_;
  Accelerations accelerations_;
  LayerState state_;
  MaterialMix mix_;
  ExtruderWords extruder_;
  bool comments_;
  // Values written last; -1: nothing written yet.
  gcode::Modal<int32_t> feed_rate_;
  int32_t type_ = -1;
  int32_t width_um_ = -1;
  int32_t height_um_;
  int32_t role_ = -1;  ///< feature of the last bead in the layer
  FanCommand fan_;
  AdvanceCommand advance_;
  int32_t z_um_ = -1;
  std::optional<PointUm> at_;
  bool wipes_ = false;
  /// true if the filament was retracted, and E has not been reset to 0 since
  bool pulled_ = false;
  bool primed_ = false;
  float acceleration_ = -1;
  float travel_acceleration_ = -1;  ///< travels' own acceleration; -1: not written
  float jerk_ = -1;
  bool approached_ = false;  ///< the first move in the plane was written
  std::vector<ModeLine> mode_lines_;
};

}  // namespace slicefarm::motion
