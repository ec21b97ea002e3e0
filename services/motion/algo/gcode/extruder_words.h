#pragma once

#include <cstdint>

#include "common/model/options/tool_row.h"
#include "common/gcode/gcode_text.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// What G-code says of the extruder: relative or absolute, as length or as volume, retractions by
/// number or left to the firmware. What rounding to the digits of the text leaves is carried on,
/// so that the sum is exact to the last digit. Absolute numbers count from 0 in each layer, and
/// again after each retraction, as PrusaSlicer's do.
class ExtruderWords {
 public:
  /// Relative lengths.
  ExtruderWords() = default;
  explicit ExtruderWords(const MotionOptions& options);

  /// Whether G10 and G11 stand for retractions, whose lengths the machine knows.
  bool by_firmware() const { return by_firmware_; }

  /// ` E..` of a move that pushes `filament`, in 1e-5 mm of its length.
  void Push(int32_t filament, GcodeText& out);

  /// Counts from 0 again. Writes `G92 E0` where numbers are absolute and not 0.
  void Reset(GcodeText& out);

  /// Units, absolute places, and how the extruder counts; it is at 0.
  void WriteCanonicalState(GcodeText& out) const;

  /// Pulls the filament back at the head of a program; nothing if that is not asked for.
  void WriteFirstRetraction(const RetractionOptions& retraction, GcodeText& out);

 private:
  bool relative_ = true;
  bool by_firmware_ = false;
  bool comments_ = false;
  double per_unit_ = 1;  ///< what stands in the text for 1 mm of filament
  int64_t pushed_ = 0;   ///< since it counts from 0, in 1e-5 mm
  int64_t told_ = 0;     ///< the same in units of the text's last digit
};

}  // namespace slicefarm::motion
