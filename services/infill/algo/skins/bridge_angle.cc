#include "services/infill/algo/skins/bridge_angle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/lines/line_ends.h"

namespace slicefarm::infill {
namespace {

constexpr int kDirections = 36;
constexpr double kInAir = 10;  ///< factor for the length of a span that ends in air
constexpr double kTypical = 0.9;
/// Relative difference up to which two directions are equally good.
constexpr double kRounding = 1e-6;
constexpr double kMaxSamples = 200;
/// Distance in nm up to which two ends are one end: where regions meet, edges are rounded.
constexpr double kSameEndNm = 5'000;

bool HasNear(std::span<const double> sorted, double u) {
  const auto it = std::lower_bound(sorted.begin(), sorted.end(), u - kSameEndNm);
  return it != sorted.end() && *it <= u + kSameEndNm;
}

/// Unsupported span of a line.
struct Span {
  double counted = 0;  ///< length with the factor for ends in air
  double length = 0;
  bool held = false;
  int tenths_held = 0;  ///< tenths of the length of all lines that are supported at both ends
};

/// Returns the 90th percentile of the spans, weighted by length. A span that ends in air counts as
/// longer (kInAir). The mean is not used: short spans of oblique lines in corners would compensate
/// longer ones. Infinite if no line meets the spans.
Span TypicalSpan(const LineEnds& spans, const LineEnds& supports) {
  std::vector<Span> found;
  double total = 0, total_held = 0;
  for (int64_t line = spans.first(); line < spans.last(); ++line) {
    const std::span<const double> ends = spans.On(line), borne = supports.On(line);
    for (size_t i = 0; i + 1 < ends.size(); i += 2) {
      const double span = ends[i + 1] - ends[i];
      const bool held = HasNear(borne, ends[i]) && HasNear(borne, ends[i + 1]);
      found.push_back({held ? span : kInAir * span, span, held});
      total += span;
      if (held) total_held += span;
    }
  }
  std::ranges::sort(found, {}, [](const Span& s) { return std::pair(s.counted, s.length); });
  double length = 0;
  for (Span& span : found) {
    span.tenths_held = static_cast<int>(10 * total_held / total);
    if ((length += span.length) >= kTypical * total) return span;
  }
  return {.counted = std::numeric_limits<double>::infinity()};
}

/// Best of the directions so far.
struct SpanChoice {
  int tenths_held = 0;
  double least = std::numeric_limits<double>::infinity();
  std::optional<BridgeSpan> best = {};

  void Consider(const Span& span, double angle_rad) {
    if (span.counted >= (1 - kRounding) * least) return;
    least = span.counted;
    best = {angle_rad, span.held};
  }
};

}  // namespace

std::optional<BridgeSpan> BridgeAngle(const PolygonWithHoles& region, const MultiPolygon& below,
                                      Coord width_nm) {
  const MultiPolygon supports = Intersection({region}, below);
  const MultiPolygon spans = Difference({region}, below);
  if (supports.empty() || spans.empty()) return std::nullopt;
  const Box box = Bounds(spans);
  const double size =
      Hypot(static_cast<double>(box.max.x - box.min.x), static_cast<double>(box.max.y - box.min.y));
  const double pitch = std::max(static_cast<double>(width_nm), size / kMaxSamples);
  SpanChoice all, most_held;
  bool any_held = false;
  for (int i = 0; i < kDirections; ++i) {
    const LineFamily family{i * std::numbers::pi / kDirections, pitch / 2, pitch};
    const auto over_air = LineEnds::Of(spans, family), borne = LineEnds::Of(supports, family);
    if (!over_air.ok() || !borne.ok()) continue;
    const Span span = TypicalSpan(*over_air, *borne);
    any_held |= span.held;
    all.Consider(span, family.angle_rad);
    if (span.tenths_held > most_held.tenths_held) most_held = {.tenths_held = span.tenths_held};
    if (span.tenths_held == most_held.tenths_held) most_held.Consider(span, family.angle_rad);
  }
  return any_held ? all.best : most_held.best;
}

}  // namespace slicefarm::infill
