#include "services/infill/algo/fields/mean_density.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {
namespace {

constexpr double kStepNm = 2e6;

}  // namespace

absl::StatusOr<double> MeanDensity(const MultiPolygon& region, const LayerField& field) {
  if (field.density == nullptr) return field.plain_density;
  const auto lines = CutLines(region, {.pitch_nm = kStepNm});
  if (!lines.ok()) return lines.status();
  double sum = 0, length = 0;
  for (int32_t piece = 0; piece < lines->PieceCount(); ++piece) {
    const Crossing& from = lines->crossings[static_cast<size_t>(lines->order[2 * piece])];
    const double v = lines->first_v + lines->pitch * from.line;
    const double whole = lines->PieceLength(piece);
    const double count = std::max(1.0, std::ceil(whole / kStepNm));
    for (double i = 0.5; i < count; ++i)
      sum += whole / count * field.DensityAt(lines->frame.At(from.u + i / count * whole, v));
    length += whole;
  }
  if (length > 0) return sum / length;
  const Box box = Bounds(region);
  return field.DensityAt(Point{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2});
}

}  // namespace slicefarm::infill
