#include "services/infill/algo/patterns/honeycomb_3d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/wave_rows.h"

namespace slicefarm::infill {
namespace {

constexpr int kSteps = 60;

double RowsApart(double pitch, double spacing) {
  double apart = pitch;
  for (int i = 0; i < kSteps; ++i)
    apart = pitch * (1 + (std::numbers::sqrt2 - 1) / 4 * std::max(0.0, 1 - spacing / apart));
  return apart;
}

/// Amplitude of the waves in a layer, in nm; `turned`: true if the rows are rotated by a right
/// angle.
struct Waves {
  double height = 0;
  bool turned = false;
};
Waves WavesAt(double z, double most) {
  if (most <= 0) return {};
  const double phase = z / (2 * most) - 2 * std::floor(z / (4 * most));  // [0, 2)
  const double within = phase - std::floor(phase);
  return {most * (1 - std::abs(2 * within - 1)), phase >= 1};
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Honeycomb3d(const MultiPolygon& region,
                                               const PatternContext& context) {
  const auto spacing = static_cast<double>(context.spacing_nm);
  const double apart = RowsApart(context.pitch_nm, spacing);
  const Waves waves =
      WavesAt(static_cast<double>(context.z_nm), std::max(0.0, (apart - spacing) / 2));
  const double period = 4 * apart, a = waves.height;
  const std::array<Vector2, 4> wave = {Vector2{a, a}, Vector2{period / 2 - a, a},
                                       Vector2{period / 2 + a, -a}, Vector2{period - a, -a}};
  const auto curves = RowsOver(
      region, {.angle_rad = context.angle_rad + (waves.turned ? std::numbers::pi / 2 : 0),
               .apart_nm = apart,
               .period_nm = period,
               .wave = a > 0 ? std::span<const Vector2>(wave) : std::span<const Vector2>()});
  if (!curves.ok()) return curves.status();
  return ClipCurves(region, *curves);
}

}  // namespace slicefarm::infill
