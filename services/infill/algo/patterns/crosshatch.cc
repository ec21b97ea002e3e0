#include "services/infill/algo/patterns/crosshatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "common/base/portable_math.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/wave_rows.h"

namespace slicefarm::infill {
namespace {

/// Height of the transition in P, and amplitude of its waves in P: at both ends and in the middle.
constexpr double kTransition = 0.4;
constexpr double kLowWave = 0.05;
constexpr double kHighWave = 0.3;
/// Number of steps that P converges in, and of steps of the integral over the transition.
constexpr int kHatchRounds = 60;
constexpr int kHatchSteps = 64;

/// Returns the height of the band of straight lines, in P.
double HatchBand(double density) {
  if (density >= 0.3) return 1;
  const double sinh = Sinh(5 * density);
  const double exp = Hypot(1, sinh) - sinh;  // of -5 * density
  return std::clamp(1 - exp, 0.2, 1.0);
}

/// Returns the length of a row with waves of amplitude `a` (in P), per length of a straight line.
/// Half a period is P long: a flat part of 2 a, and a slope over 1 - 2 a in length and 2 a in
/// height.
double RowLength(double a) { return 2 * a + std::sqrt((1 - 2 * a) * (1 - 2 * a) + 4 * a * a); }

/// Returns the amplitude of the waves in P. `progress`: from 0 at one end of the transition to 1 in
/// its middle. `space`: largest amplitude that keeps neighbours a spacing apart, in P.
double HatchWave(double progress, double space) {
  return std::min(kLowWave + (kHighWave - kLowWave) * progress, space);
}

/// Returns the mean length of a row over a period, per length of a straight line.
double MeanRowLength(double band, double space) {
  double sum = 0;
  for (int i = 0; i < kHatchSteps; ++i) sum += RowLength(HatchWave((i + 0.5) / kHatchSteps, space));
  return (band + kTransition * sum / kHatchSteps) / (band + kTransition);
}

/// Returns the largest amplitude of waves that keeps neighbours a spacing apart, in P. `apart` (P),
/// `spacing` in nm.
double SpaceForWaves(double apart, double spacing) {
  return std::max(0.0, (1 - spacing / apart) / 2);
}

/// Returns P in nm.
double HatchApart(double pitch, double spacing, double band) {
  double apart = pitch;
  for (int i = 0; i < kHatchRounds; ++i)
    apart = pitch * MeanRowLength(band, SpaceForWaves(apart, spacing));
  return apart;
}

/// Amplitude of the waves in P; `transposed`: true if the rows lead along v.
struct HatchRows {
  double wave = 0;
  bool transposed = false;
};

/// Returns the rows at a height in P. As in OrcaSlicer, the bed is within a transition, or near
/// one: the first layers are joined to both directions.
HatchRows HatchRowsAt(double z, double band, double space) {
  const double period = band + kTransition;
  const double height = z + band / 2 + kTransition;
  const double turns = std::floor(height / period);
  const bool odd = turns - 2 * std::floor(turns / 2) != 0;
  const double progress = (height - turns * period - band) / kTransition;  // of the transition
  if (progress < 0) return {0, !odd};
  const bool second_half = progress >= 0.5;
  const double from_end = second_half ? 2 - 2 * progress : 2 * progress;
  return {HatchWave(from_end, space), odd == second_half};
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Crosshatch(const MultiPolygon& region,
                                              const PatternContext& context) {
  const auto spacing = static_cast<double>(context.spacing_nm);
  const double band = HatchBand(spacing / context.pitch_nm);
  const double apart = HatchApart(context.pitch_nm, spacing, band);
  const HatchRows rows =
      HatchRowsAt(static_cast<double>(context.z_nm) / apart, band, SpaceForWaves(apart, spacing));
  const double a = rows.wave * apart;
  const std::array<Vector2, 4> wave = {Vector2{0.5 * apart - a, a}, Vector2{0.5 * apart + a, a},
                                       Vector2{1.5 * apart - a, -a}, Vector2{1.5 * apart + a, -a}};
  const auto curves = RowsOver(
      region, {.angle_rad = context.angle_rad,
               .transposed = rows.transposed,
               .apart_nm = apart,
               .period_nm = 2 * apart,
               .wave = a > 0 ? std::span<const Vector2>(wave) : std::span<const Vector2>()});
  if (!curves.ok()) return curves.status();
  return ClipCurves(region, *curves);
}

}  // namespace slicefarm::infill
