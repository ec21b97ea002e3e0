#include "services/motion/algo/gcode/extruder_words.h"

#include <cmath>

#include "common/model/options/motion_options.h"
#include "common/model/options/tool_row.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {

ExtruderWords::ExtruderWords(const MotionOptions& options)
    : relative_(options.writing.relative_e),
      by_firmware_(options.writing.firmware_retraction),
      comments_(options.writing.comments),
      per_unit_(options.writing.volumetric_e ? FilamentAreaMm2(options) : 1) {}

void ExtruderWords::Push(int32_t filament, GcodeText& out) {
  pushed_ += filament;
  const int64_t place = std::llround(static_cast<double>(pushed_) * per_unit_);
  out << " E";
  out.Filament(relative_ ? place - written_ : place);
  written_ = place;
}

void ExtruderWords::Reset(GcodeText& out) {
  if (!relative_ && written_ != 0)
    out << (comments_ ? "G92 E0 ; reset extrusion distance\n" : "G92 E0\n");
  pushed_ = written_ = 0;
}

void ExtruderWords::WriteCanonicalState(GcodeText& out) const {
  out << (relative_ ? "G21\nG90\nM83\n" : "G21\nG90\nM82\nG92 E0\n");
}

void ExtruderWords::WriteFirstRetraction(const RetractionOptions& retraction, GcodeText& out) {
  if (retraction.length_mm <= 0) return;
  if (by_firmware_) {
    out << "G10\n";
    return;
  }
  out << "G1";
  Push(static_cast<int32_t>(std::lround(-retraction.length_mm * kFilamentUnitsPerMm)), out);
  out << " F";
  out.Integer(FeedRate(retraction.speed_mm_s)) << '\n';
  Reset(out);
}

}  // namespace slicefarm::motion
