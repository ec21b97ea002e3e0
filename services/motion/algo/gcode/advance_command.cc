#include "services/motion/algo/gcode/advance_command.h"

#include <algorithm>
#include <cmath>

#include "common/base/portable_math.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// Largest relative difference of sections that count as one flow.
constexpr double kSameFlow = 0.02;

double BeadLengthMm(const Toolpath& path, size_t index) {
  const Move &from = path.moves[index - 1], &to = path.moves[index];
  return Hypot(to.x_um - from.x_um, to.y_um - from.y_um) / kUmPerMm;
}

double FilamentMmOf(const Move& move) {
  return static_cast<double>(move.filament) / kFilamentUnitsPerMm;
}

/// Returns the filament per length of a bead; 0 for the first move of a path.
double DensityOf(const Toolpath& path, size_t index) {
  const double length_mm = index > 0 ? BeadLengthMm(path, index) : 0;
  return length_mm > 0 ? FilamentMmOf(path.moves[index]) / length_mm : 0;
}

}  // namespace

std::optional<AdvanceControl> AdvanceControl::Of(const MotionOptions& options) {
  const AdaptiveAdvance& advance = options.tool().advance;
  if (!advance.on) return std::nullopt;
  const auto points = ParseAdvancePoints(advance.model);
  AdvanceModel model(points.ok() ? *points : std::vector<AdvancePoint>{});
  if (model.empty()) return std::nullopt;
  return AdvanceControl{.model = std::move(model),
                        .within_features = advance.within_features,
                        .bridges = advance.bridges,
                        .filament_mm2 = FilamentAreaMm2(options)};
}

void AdvanceCommand::SetFor(const Toolpath& path, size_t index, GcodeText& out) {
  if (control_ == nullptr) return;
  const bool known = path_ == &path && first_ <= index && index < last_;
  if (known && written_ >= 0) return;
  path_ = &path;
  first_ = index;
  last_ = EndOfRun(path, index);
  const double value = ValueOf(path, first_, last_);
  if (value == written_) return;
  written_ = value;
  firmware_.WritePressureAdvance(value, out);
}

/// Returns the end of the beads that get one value, beginning at `first`.
size_t AdvanceCommand::EndOfRun(const Toolpath& path, size_t first) const {
  const Move& begin = path.moves[first];
  const double density = DensityOf(path, first);
  size_t last = first + 1;
  for (; last < path.moves.size(); ++last) {
    const Move& move = path.moves[last];
    if (move.kind != MoveKind::kPrint || move.feature != begin.feature) break;
    if (!control_->within_features) continue;
    const bool same = std::abs(DensityOf(path, last) - density) <= kSameFlow * density;
    if (move.feed_rate != begin.feed_rate || !same) break;
  }
  return last;
}

double AdvanceCommand::ValueOf(const Toolpath& path, size_t first, size_t last) const {
  const Move& begin = path.moves[first];
  const bool bridge = IsBridge(begin.feature) || begin.feature == Feature::kOverhangPerimeter;
  if (bridge && control_->bridges > 0) return control_->bridges;
  double filament_mm = 0, length_mm = 0;
  int32_t fastest = 0;
  for (size_t i = std::max<size_t>(first, 1); i < last; ++i) {
    filament_mm += FilamentMmOf(path.moves[i]);
    length_mm += BeadLengthMm(path, i);
    fastest = std::max(fastest, path.moves[i].feed_rate);
  }
  const double section_mm2 = length_mm > 0 ? filament_mm / length_mm * control_->filament_mm2 : 0;
  return control_->model.At(section_mm2 * SpeedOf(fastest), begin.acceleration_mm_s2);
}

}  // namespace slicefarm::motion
