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
#include "services/motion/algo/gcode/extruder_words.h"
#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/cooling.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// A fan that stays as it is.
inline constexpr int32_t kFanAsBefore = -1;

/// What the head of a layer has told already, and what its fan is to be.
struct LayerState {
  int32_t height_um = -1;
  int32_t fan_percent = 0;                                ///< of the layer; may be kFanAsBefore
  int32_t bridge_fan_percent = 0;                         ///< for bridges and overhangs
  std::optional<OverhangFans> overhang_fan_percent = {};  ///< for walls over air
  ShiftUm to_plate = {};  ///< from places in the G-code to those on the plate
};

/// Writes moves as G-code, with what previewers and the firmware have to be told on the way:
/// `;TYPE:`, `;WIDTH:` and `;HEIGHT:` where they change, accelerations, fan. Feed rates stand only
/// where they change, and so do coordinates within a stretch. The toolpath's arcs are written as
/// such, with the sum of their filament.
class LayerWriter {
 public:
  /// `firmware` must live on. `materials`: what is mixed where; null: nothing. It must outlive the
  /// writer. `comments`: each line says what it is for.
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
        fan_percent_(state.fan_percent) {}

  /// Tells the layer's fan.
  void WriteLayerFan(GcodeText& out);

  /// Appends the moves [first, last), shifted. May be called for one stretch after the other: the
  /// first move of each says its whole place, whatever text of others stands before it, and whether
  /// or not the machine has left out the copy before.
  void Write(const Toolpath& path, size_t first, size_t last, ShiftUm shift, GcodeText& out);

  /// Around a block: its text is the same whatever comes before it, but for accelerations that are
  /// set already, and fan and height are then as the head of the layer has told them.
  void BeginBlock(GcodeText& out);
  void EndBlock(GcodeText& out);

  /// The filament is ready, whatever the moves say: a change of colour has primed it. The next
  /// restart is left out.
  void Prime() { primed_ = true; }

  /// Lines that tell what may be set already, as nothing of it was known: LayerProgram::mode_lines.
  std::vector<ModeLine> TakeModeLines() { return std::move(mode_lines_); }
  /// What is set after all that was written; empty values: nothing was told.
  ModeValues Modes() const;

  /// After text of others, which may have set feed rate and acceleration: they are told anew. A fan
  /// that it sets stays as it is.
  void Forget() {
    feed_rate_.Forget();
    acceleration_ = -1;
    travel_acceleration_ = -1;
  }

  /// After text of others that moves in z: the next travel says its height.
  void ForgetHeight() { z_um_ = std::numeric_limits<int32_t>::min(); }

 private:
  void WriteMove(const Toolpath& path, size_t index, ShiftUm shift, GcodeText& out);
  void WriteIfNeeded(const Toolpath& path, size_t index, GcodeText& out);
  bool WriteByFirmware(const Move& move, GcodeText& out);
  void CountAnew(const Move& move, GcodeText& out);
  void WriteArc(const Toolpath& path, const MoveArc& arc, ShiftUm shift, GcodeText& out);
  void TellWipe(bool wipes, GcodeText& out);
  void WritePlace(PlaceUm to, GcodeText& out);
  void WriteEnd(const Move& move, std::string_view comment, GcodeText& out);
  int32_t FanFor(const Move& move) const;
  void SetFan(int32_t percent, GcodeText& out);
  void SetHeight(int32_t height_um, GcodeText& out);
  void Describe(const Move& move, double length_um, GcodeText& out);
  void SetAcceleration(const Move& move, GcodeText& out);
  void SetAcceleration(MachineMode mode, float value, float& told, GcodeText& out);
  void WriteAcceleration(MachineMode mode, float value, GcodeText& out) const;
  void FeedRate(const Move& move, GcodeText& out);

  const Firmware& firmware_;
  Accelerations accelerations_;
  LayerState state_;
  MaterialMix mix_;
  ExtruderWords extruder_;
  bool comments_;
  // What has been told; -1: nothing.
  gcode::Modal<int32_t> feed_rate_;
  int32_t type_ = -1;
  int32_t width_um_ = -1;
  int32_t height_um_;
  int32_t fan_percent_;
  int32_t z_um_ = -1;
  std::optional<PlaceUm> at_;
  bool wipes_ = false;
  bool pulled_ = false;  ///< the filament went back, and the extruder has not counted anew since
  bool primed_ = false;
  float acceleration_ = -1;
  float travel_acceleration_ = -1;  ///< what travels have apart; -1: not told
  bool approached_ = false;         ///< a first move in the plane was written
  std::vector<ModeLine> mode_lines_;
};

/// `M106 S89`, or `M107` for 0.
void WriteFan(int32_t percent, GcodeText& out);

}  // namespace slicefarm::motion
