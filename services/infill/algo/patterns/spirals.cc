#include "services/infill/algo/patterns/spirals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/frame_box.h"
#include "services/infill/algo/lines/level_lines.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kChordToleranceNm = 50'000;
constexpr int kCorners = 16;

/// Distances from the origin to the nearest and the farthest point of a region's box.
struct Radii {
  double least = 0;
  double most = 0;
};
Radii RadiiOf(const MultiPolygon& region, const LineAxes& frame) {
  const FrameBox box = BoxIn(frame, region);
  const double near_u = std::clamp(0.0, box.min_u, box.max_u);
  const double near_v = std::clamp(0.0, box.min_v, box.max_v);
  const double far_u = std::max(std::abs(box.min_u), std::abs(box.max_u));
  const double far_v = std::max(std::abs(box.min_v), std::abs(box.max_v));
  return {std::sqrt(near_u * near_u + near_v * near_v), std::sqrt(far_u * far_u + far_v * far_v)};
}

/// Returns the number of chords per turn. Corners are a third of a chord's rise outside of the
/// curve, so that the length is the same. The rise may therefore be 1.5 times the tolerance.
double ChordsAt(double radius_nm) {
  const double rise = std::min(1.5 * kChordToleranceNm, radius_nm / 8);
  return std::ceil(std::numbers::pi / Acos(1 - rise / radius_nm));
}

/// Returns the turn at which a spiral begins, so that the part within `least` of the origin is
/// skipped. It is a whole number of turns, so that all regions get the same points of the spiral.
double FirstTurn(double least_nm, double nm_per_turn) {
  return std::max(0.0, std::floor(least_nm / nm_per_turn) - 1);
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Archimedean(const MultiPolygon& region,
                                               const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  const LineAxes frame(context.angle_rad);
  const Radii radii = RadiiOf(region, frame);
  const double last = std::ceil(radii.most / context.pitch_nm) + 1;
  const double chords_at_most = last * ChordsAt(last * context.pitch_nm);
  if (absl::Status ok = CheckLineCount(chords_at_most); !ok.ok()) return ok;
  Curve spiral;
  for (double turn = FirstTurn(radii.least, context.pitch_nm); turn < last; ++turn) {
    const double chords = ChordsAt((turn + 1) * context.pitch_nm);
    const double half = std::numbers::pi / chords;
    const double outside = half * half / 6;
    for (double i = 0; i < chords; ++i) {
      const double at = turn + i / chords;
      const double r = at * context.pitch_nm * (1 + outside);
      spiral.points.push_back(
          frame.At(r * Cos(kTurn * (i / chords)), r * Sin(kTurn * (i / chords))));
    }
  }
  return ClipCurves(region, {&spiral, 1});
}

absl::StatusOr<std::vector<Piece>> Octagram(const MultiPolygon& region,
                                            const PatternContext& context) {
  if (region.empty()) return std::vector<Piece>{};
  const LineAxes frame(context.angle_rad);
  // The star has its outer corners at radius 1. These are the distances of its edges and of its
  // inner corners from the middle.
  const double edge = std::numbers::sqrt2 / 2;
  const double inner = edge / Cos(kTurn / kCorners);
  std::array<Vector2, kCorners> star;
  for (int i = 0; i < kCorners; ++i) {
    const double r = i % 2 == 0 ? 1 : inner;
    star[static_cast<size_t>(i)] = {r * Cos(kTurn * i / kCorners), r * Sin(kTurn * i / kCorners)};
  }
  const double growth = context.pitch_nm / edge;  // growth of the outer corners per turn
  const Radii radii = RadiiOf(region, frame);
  const double last = std::ceil(radii.most / (inner * growth)) + 2;
  if (absl::Status ok = CheckLineCount(last * kCorners); !ok.ok()) return ok;
  Curve spiral;
  for (double turn = FirstTurn(radii.least, growth); turn < last; ++turn) {
    for (int i = 0; i < kCorners; ++i) {
      const double r = (turn + static_cast<double>(i) / kCorners) * growth;
      spiral.points.push_back(
          frame.At(r * star[static_cast<size_t>(i)].x(), r * star[static_cast<size_t>(i)].y()));
    }
  }
  return ClipCurves(region, {&spiral, 1});
}

}  // namespace slicefarm::infill
