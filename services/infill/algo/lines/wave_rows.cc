#include "services/infill/algo/lines/wave_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Curve>> RowsOver(const MultiPolygon& region, const WaveRows& rows) {
  if (region.empty()) return std::vector<Curve>{};
  const LineAxes frame(rows.angle_rad);
  FrameBox box = BoxIn(frame, region);
  if (rows.transposed) {
    std::swap(box.min_u, box.min_v);
    std::swap(box.max_u, box.max_v);
  }
  const auto at = [&](double u, double v) {
    return rows.transposed ? frame.At(v, u) : frame.At(u, v);
  };
  const double first = std::floor(box.min_v / rows.apart_nm) - 1;
  const double last = std::ceil(box.max_v / rows.apart_nm) + 1;
  const double from = std::floor(box.min_u / rows.period_nm) - 1;
  const double to = std::ceil(box.max_u / rows.period_nm) + 1;
  const double points = static_cast<double>(std::max<size_t>(1, rows.wave.size()));
  if (absl::Status ok = CheckLineCount((last - first) * (to - from) * points); !ok.ok()) return ok;
  std::vector<Curve> curves;
  for (double row = first; row <= last; ++row) {
    Polyline& line = curves.emplace_back().points;
    const double v = row * rows.apart_nm;
    if (rows.wave.empty()) {
      line = {at(from * rows.period_nm, v), at(to * rows.period_nm, v)};
      continue;
    }
    const double sign = std::fmod(std::abs(row), 2) == 0 ? 1 : -1;
    for (double k = from; k <= to; ++k)
      for (const Vector2& point : rows.wave)
        line.push_back(at(k * rows.period_nm + point.x(), v + sign * point.y()));
  }
  return curves;
}

}  // namespace slicefarm::infill
