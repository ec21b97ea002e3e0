#include "services/infill/algo/patterns/honeycomb_3d.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

constexpr int kSteps = 60;

double RowsApart(double pitch, double spacing) {
  double apart = pitch;
  for (int i = 0; i < kSteps; ++i)
    apart = pitch * (1 + (std::numbers::sqrt2 - 1) / 4 * std::max(0.0, 1 - spacing / apart));
  return apart;
}

/// Height of the waves in a layer, and true if the rows are turned.
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
                                               const PatternPlace& place) {
  if (region.empty()) return std::vector<Piece>{};
  const auto spacing = static_cast<double>(place.spacing_nm);
  const double apart = RowsApart(place.pitch_nm, spacing);
  const Waves waves =
      WavesAt(static_cast<double>(place.z_nm), std::max(0.0, (apart - spacing) / 2));
  const LineAxes frame(place.angle_rad + (waves.turned ? std::numbers::pi / 2 : 0));
  const FrameBox box = BoxIn(frame, region);
  const double period = 4 * apart, a = waves.height;
  const double first = std::floor(box.min_v / apart) - 1, last = std::ceil(box.max_v / apart) + 1;
  const double from = std::floor(box.min_u / period) - 1, to = std::ceil(box.max_u / period) + 1;
  if (absl::Status ok = CheckLineCount((last - first) * (to - from) * 4); !ok.ok()) return ok;
  std::vector<Curve> curves;
  for (double row = first; row <= last; ++row) {
    Polyline& points = curves.emplace_back().points;
    const double up = std::fmod(std::abs(row), 2) == 0 ? a : -a;
    const double v = row * apart;
    if (a == 0) {
      points = {frame.At(from * period, v), frame.At(to * period, v)};
      continue;
    }
    for (double k = from; k <= to; ++k) {
      const double u = k * period;
      points.push_back(frame.At(u + a, v + up));
      points.push_back(frame.At(u + period / 2 - a, v + up));
      points.push_back(frame.At(u + period / 2 + a, v - up));
      points.push_back(frame.At(u + period - a, v - up));
    }
  }
  return ClipCurves(region, curves);
}

}  // namespace slicefarm::infill
