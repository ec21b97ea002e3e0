#include "services/motion/algo/firmware/prusa_buddy.h"

#include <cmath>

#include "common/base/shared/shared_text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/text/commands.h"
#include "services/motion/algo/text/comment_text.h"

namespace slicefarm::motion {
namespace {

/// Returns the model's name without characters that may not be between quotes.
std::string Quotable(std::string_view model) {
  std::string plain = CommentLine(model);
  std::erase_if(plain, [](char c) { return c == '"' || c == ';' || c == '\\'; });
  return plain;
}

/// Source: Prusa-Firmware-Buddy, M862, M555, M572, and its G-code files.
class BuddyFirmware : public MarlinFirmware {
 public:
  std::string_view name() const override { return "prusabuddy"; }

  void WritePressureAdvance(double value, GcodeText& out) const override {
    out << "M572 S";
    out.Real(value, 5) << '\n';
  }

  /// Checks that the start G-code contains are not written again.
  void WriteChecks(const MotionOptions& options, const PrintFacts& facts,
                   GcodeText& out) const override {
    if (!StartCommands(options, {"M862"})) {
      out << "M862.1 P";
      out.Real(options.tool().nozzle_diameter_mm, 3) << '\n';
      if (!options.printer_model.empty())
        out << "M862.3 P \"" << Quotable(options.printer_model) << "\"\n";
    }
    if (!facts.first_layer.Empty() && !StartCommands(options, {"M555"}))
      WriteArea(facts.first_layer, out);
  }

 private:
  /// Writes the area to probe: the bounds of the first layer, rounded outwards to whole
  /// millimetres.
  static void WriteArea(const Box& bounds, GcodeText& out) {
    const auto floor_mm = [](Coord nm) {
      return static_cast<int64_t>(std::floor(ToMm(static_cast<double>(nm))));
    };
    const int64_t x = floor_mm(bounds.min.x), y = floor_mm(bounds.min.y);
    out << "M555 X";
    out.Integer(x) << " Y";
    out.Integer(y) << " W";
    out.Integer(-floor_mm(-bounds.max.x) - x) << " H";
    out.Integer(-floor_mm(-bounds.max.y) - y) << '\n';
  }
};

}  // namespace

const Firmware& PrusaBuddy() {
  static const BuddyFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
