#pragma once

#include <cstdint>

#include "common/gcode/gcode_text.h"
#include "common/model/options/tool_row.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Writes the E words of moves: relative or absolute, as length or as volume. Retractions are
/// written as E words, or as G10 and G11. Rounding remainders are added to the next number, so the
/// sum is exact to the last digit. Absolute numbers restart at 0 in each layer and after each
/// retraction, as in PrusaSlicer.
class ExtruderWords {
 public:
  /// Writes relative lengths.
  ExtruderWords() = default;
  /// Chooses absolute or relative numbers, lengths or volumes, and G10/G11 as the options say.
  explicit ExtruderWords(const MotionOptions& options);

  /// Returns true if retractions are written as G10 and G11. Their lengths are settings of the
  /// machine.
  bool by_firmware() const { return by_firmware_; }

  /// Writes the word ` E..` of a move that extrudes `filament`, a length in 1e-5 mm; a negative
  /// length retracts.
  void Push(int32_t filament, GcodeText& out);

  /// Restarts the count at 0. Writes `G92 E0` if numbers are absolute and not 0.
  void Reset(GcodeText& out);

  /// Writes the canonical state: millimetres, absolute coordinates, the mode of E, and E = 0.
  void WriteCanonicalState(GcodeText& out) const;

  /// Writes the retraction with which a program starts. Writes nothing if the retraction length is
  /// 0.
  void WriteFirstRetraction(const RetractionOptions& retraction, GcodeText& out);

 private:
  bool relative_ = true;
  bool by_firmware_ = false;
  bool comments_ = false;
  double per_unit_ = 1;  ///< value in the text per mm of filament
  int64_t pushed_ = 0;   ///< length extruded since the last reset to 0, in 1e-5 mm
  /// length written since the last reset to 0, in units of the text's last digit
  int64_t written_ = 0;
};

}  // namespace slicefarm::motion
