#include "services/infill/algo/patterns/honeycomb.h"

#include <cmath>
#include <numbers>

#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

constexpr double kSqrt3 = std::numbers::sqrt3;
constexpr int kBisections = 60;

/// Returns the length per area of rows of hexagons with sides of length `side`. The sloped parts of
/// a row are shortened by `gap`, half of it at each end.
double LengthPerArea(double side, double gap) {
  const double rise = kSqrt3 / 2 * side - gap;
  const double slope = std::sqrt(side * side / 4 + rise * rise);
  return (2 * side + 2 * slope) / (3 * side * kSqrt3 / 2 * side);
}

/// Returns the length of a hexagon's side for which rows with flat parts `gap` apart have the
/// density of lines `pitch` apart.
double SideFor(double pitch, double gap) {
  double low = pitch / 2, high = 2 * pitch;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    (LengthPerArea(middle, gap) > 1 / pitch ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Rows near a region. Row r has its middle at v = r * rise. Odd rows begin half a period later.
struct Rows {
  LineAxes frame;
  FrameBox box;
  double side = 0;

  double Rise() const { return kSqrt3 / 2 * side; }
  double Period() const { return 3 * side; }
  double First() const { return std::floor(box.min_v / Rise()) - 1; }
  double Last() const { return std::ceil(box.max_v / Rise()) + 1; }
  double FirstPeriod() const { return std::floor(box.min_u / Period()) - 1; }
  double LastPeriod() const { return std::ceil(box.max_u / Period()) + 1; }
  double Start(double row) const { return std::fmod(std::abs(row), 2) == 1 ? 1.5 * side : 0; }
  absl::Status Check() const {
    return CheckLineCount((Last() - First()) * (LastPeriod() - FirstPeriod()) * 4);
  }
};

}  // namespace

absl::StatusOr<std::vector<Piece>> Honeycomb(const MultiPolygon& region,
                                             const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  const LineAxes frame(context.angle_rad);
  const auto gap = static_cast<double>(context.spacing_nm);
  const Rows rows{frame, BoxIn(frame, region), SideFor(context.pitch_nm, gap)};
  if (absl::Status ok = rows.Check(); !ok.ok()) return ok;
  const double s = rows.side, high = (rows.Rise() - gap) / 2;
  std::vector<Curve> curves;
  for (double row = rows.First(); row <= rows.Last(); ++row) {
    Polyline& points = curves.emplace_back().points;
    const double v = row * rows.Rise();
    for (double k = rows.FirstPeriod(); k <= rows.LastPeriod(); ++k) {
      const double u = rows.Start(row) + k * rows.Period();
      points.push_back(frame.At(u, v + high));
      points.push_back(frame.At(u + s, v + high));
      points.push_back(frame.At(u + 1.5 * s, v - high));
      points.push_back(frame.At(u + 2.5 * s, v - high));
    }
  }
  return ClipCurves(region, curves);
}

absl::StatusOr<std::vector<Piece>> HoneycombCells(const MultiPolygon& region,
                                                  const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  const LineAxes frame(context.angle_rad);
  const Rows rows{frame, BoxIn(frame, region), 2 / kSqrt3 * context.pitch_nm};
  if (absl::Status ok = rows.Check(); !ok.ok()) return ok;
  const double s = rows.side, high = rows.Rise() / 2;
  std::vector<Curve> curves;
  for (double row = rows.First(); row <= rows.Last(); ++row) {
    const double v = row * rows.Rise();
    for (double k = rows.FirstPeriod(); k <= rows.LastPeriod(); ++k) {
      // The row rises, follows the upper flat part, and falls. The lower flat part is the upper one
      // of the next row.
      const double u = rows.Start(row) + k * rows.Period();
      curves.push_back({{frame.At(u - s / 2, v - high), frame.At(u, v + high),
                         frame.At(u + s, v + high), frame.At(u + 1.5 * s, v - high)}});
    }
  }
  return ClipCurves(region, curves);
}

}  // namespace slicefarm::infill
