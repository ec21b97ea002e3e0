#include "services/infill/algo/patterns/surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "services/infill/algo/lines/tiled_lines.h"

namespace slicefarm::infill {
namespace {

/// Largest distance of a straight segment from the points of the section, in nm; for small periods
/// a limit in periods also applies. Together with the points' own error, a segment is within 50 um
/// of the surface.
constexpr double kSurfaceToleranceNm = 40'000;
constexpr double kTolerancePeriods = 0.01;
/// Size and number of squares of the grid on which sections are found. The grid is so fine that the
/// surface is almost straight between two of its lines.
constexpr double kSampleNm = 250'000;
constexpr int kLeastSquares = 32;
constexpr int kMostSquares = 96;

/// Sine and cosine of a coordinate.
struct SineCosine {
  explicit SineCosine(double periods)
      : sine(Sin(2 * std::numbers::pi * periods)), cosine(Cos(2 * std::numbers::pi * periods)) {}
  double sine;
  double cosine;

  double CosOfTwice() const { return cosine * cosine - sine * sine; }
};

/// Returns the section of a surface at the layer's height. `value(x, y, z)`: function of three
/// Turns; `pitches`: the period in pitches.
template <typename Value>
absl::StatusOr<std::vector<Piece>> Section(const MultiPolygon& region,
                                           const PatternContext& context, double pitches,
                                           Value value) {
  const double period = pitches * context.pitch_nm;
  const double height = static_cast<double>(context.z_nm) / period;
  const SineCosine z(height - std::floor(height));
  const int squares =
      static_cast<int>(std::clamp(period / kSampleNm, 1.0 * kLeastSquares, 1.0 * kMostSquares));
  std::vector<LevelLine> lines = LevelLines(
      [&](Vector2 at) { return value(SineCosine(at.x()), SineCosine(at.y()), z); }, squares);
  const double tolerance = std::min(kSurfaceToleranceNm / period, kTolerancePeriods);
  for (LevelLine& line : lines) line = WithLongSegments(line, tolerance);
  const auto curves = TiledLines(region, lines, LineAxes(context.angle_rad), period);
  if (!curves.ok()) return curves.status();
  return ClipCurves(region, *curves);
}

constexpr double kGyroidPitches = 2.4561;

absl::StatusOr<std::vector<Piece>> GyroidOf(const MultiPolygon& region,
                                            const PatternContext& context, double pitches) {
  return Section(region, context, pitches,
                 [](const SineCosine& x, const SineCosine& y, const SineCosine& z) {
                   return x.sine * y.cosine + y.sine * z.cosine + z.sine * x.cosine;
                 });
}

/// Returns the point (stretch * u, v), where u and v are the coordinates of `p` in `axes`, as a
/// point with these coordinates in `into`.
Point Stretched(Point p, const LineAxes& axes, double stretch, const LineAxes& into) {
  return into.At(stretch * axes.U(p), axes.V(p));
}

/// Returns a gyroid with context.shape.gyroid_waves waves along u for one wave along v and z: the
/// section of a gyroid in the region stretched along u, with its lines compressed again.
absl::StatusOr<std::vector<Piece>> StretchedGyroid(const MultiPolygon& region,
                                                   const PatternContext& context) {
  const double waves = context.shape.gyroid_waves;
  const double x = Log1p(waves - 1);
  const double sinh = Sinh(x / 3);
  const double root = sinh + std::sqrt(1 + sinh * sinh);  // the cube root of `waves`
  // Length of the lines, relative to a gyroid with the same volume of a period. Fitted to integrals
  // for 0.5 to 2 waves, within 1e-4.
  const double length = 1 + x * (0.16662 + x * (0.21882 + x * 0.034856));
  const LineAxes axes(context.angle_rad), plain(0);
  MultiPolygon wide = region;
  for (PolygonWithHoles& island : wide) {
    for (Point& p : island.outer) p = Stretched(p, axes, waves, plain);
    for (Polygon& hole : island.holes)
      for (Point& p : hole) p = Stretched(p, axes, waves, plain);
  }
  PatternContext straight = context;
  straight.angle_rad = 0;
  auto pieces = GyroidOf(wide, straight, kGyroidPitches * length * root);
  if (!pieces.ok()) return pieces;
  for (Piece& piece : *pieces)
    for (Point& p : piece.points) p = axes.At(plain.U(p) / waves, plain.V(p));
  return pieces;
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Gyroid(const MultiPolygon& region,
                                          const PatternContext& context) {
  if (context.shape.gyroid_waves != 1) return StretchedGyroid(region, context);
  return GyroidOf(region, context, kGyroidPitches);
}

absl::StatusOr<std::vector<Piece>> SchwarzD(const MultiPolygon& region,
                                            const PatternContext& context) {
  return Section(region, context, 3.043,
                 [](const SineCosine& x, const SineCosine& y, const SineCosine& z) {
                   return x.cosine * y.cosine * z.cosine - x.sine * y.sine * z.sine;
                 });
}

absl::StatusOr<std::vector<Piece>> FischerKochS(const MultiPolygon& region,
                                                const PatternContext& context) {
  return Section(region, context, 4.264,
                 [](const SineCosine& x, const SineCosine& y, const SineCosine& z) {
                   return x.CosOfTwice() * y.sine * z.cosine + y.CosOfTwice() * z.sine * x.cosine +
                          z.CosOfTwice() * x.sine * y.cosine;
                 });
}

}  // namespace slicefarm::infill
