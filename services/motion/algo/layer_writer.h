#pragma once

#include "common/model/motion_options.h"
#include "services/motion/algo/accelerations.h"
#include "services/motion/algo/gcode_text.h"
#include "services/motion/algo/toolpath.h"

namespace slicefarm::motion {

/// Fan in percent while a layer is printed.
struct FanSpeeds {
  int32_t normal = 0;
  int32_t bridges = 0;  ///< and overhangs
};

/// Writes moves as G-code, with what previewers and the firmware have to be told on the way:
/// `;TYPE:`, `;WIDTH:` and
/// `;HEIGHT:` where they change, accelerations, fan. Feed rates stand only where they change.
class LayerWriter {
 public:
  LayerWriter(GcodeFlavor flavor, const Accelerations& accelerations, FanSpeeds fan)
      : flavor_(flavor), accelerations_(accelerations), fan_(fan) {}

  /// Appends the moves [first, last). May be called for one stretch after the other, with other
  /// text in between: nothing is taken as known at the start of a stretch but the position.
  void Write(const Toolpath& path, size_t first, size_t last, GcodeText& out);

 private:
  void WriteMove(const Move& move, GcodeText& out);
  void Describe(const Move& move, GcodeText& out);
  void SetAcceleration(const Move& move, GcodeText& out);
  void FeedRate(const Move& move, GcodeText& out);

  GcodeFlavor flavor_;
  const Accelerations& accelerations_;
  FanSpeeds fan_;
  // What has been told; -1: nothing.
  int32_t feed_rate_ = -1;
  int32_t type_ = -1;
  int32_t width_um_ = -1;
  int32_t height_um_ = -1;
  int32_t fan_percent_ = -1;
  float acceleration_ = -1;
};

/// `M106 S89`, or `M107` for 0.
void WriteFan(int32_t percent, GcodeText& out);

}  // namespace slicefarm::motion
